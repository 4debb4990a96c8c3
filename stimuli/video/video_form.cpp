#include "stimuli/video/video_form.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "stimuli/base/lower_case.hpp"

namespace bimodal {

namespace {

constexpr std::array kForms{VideoForm{.ending = ".mp4",
                                      .about = "H.264 and AAC",
                                      .has_sound = true,
                                      .factor = RateFactor{.usual = 16, .coarsest = 51}},
                            VideoForm{.ending = ".webm",
                                      .about = "VP9 and Opus",
                                      .has_sound = true,
                                      .factor = RateFactor{.usual = 18, .coarsest = 63}},
                            VideoForm{.ending = ".gif", .about = "256 colours", .is_gif = true}};

}  // namespace

std::span<const VideoForm> video_forms() {
  return kForms;
}

const VideoForm* video_form_of(const std::filesystem::path& file) {
  const auto ending = lower_case(file.extension().string());
  const auto* const found = std::ranges::find(kForms, ending, &VideoForm::ending);
  return found == kForms.end() ? nullptr : found;
}

std::int64_t most_frames(const VideoForm& form, std::size_t width, std::size_t height) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 30U;
  constexpr std::size_t kBytesPerPixel = 4;
  if (!form.is_gif) return std::numeric_limits<std::int64_t>::max();
  return static_cast<std::int64_t>(kMostBytes / (width * height * kBytesPerPixel));
}

FrameRate rate_in(const VideoForm& form, const FrameRate& wanted) {
  if (!form.is_gif) return wanted;
  constexpr std::int64_t kShortest = 2;
  constexpr std::int64_t kHundredths = 100;
  const auto each = std::max<std::int64_t>(
      kShortest, std::llround(static_cast<double>(kHundredths) / wanted.hertz().count()));
  return frame_rate_of(kHundredths, each);
}

}  // namespace bimodal
