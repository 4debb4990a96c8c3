#include "stimuli/video/video_form.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "stimuli/base/lower_case.hpp"

namespace bimodal {

namespace {

constexpr std::array kForms{
    VideoForm{.ending = ".mp4",
              .about = "H.264 and AAC",
              .has_sound = true,
              .factor = RateFactor{.usual = 16, .coarsest = 51}},
    VideoForm{.ending = ".webm",
              .about = "VP9 and Opus",
              .has_sound = true,
              .factor = RateFactor{.usual = 18, .coarsest = 63}},
    VideoForm{.ending = ".gif", .about = "256 colours", .is_timed_in_hundredths = true}};

}  // namespace

std::span<const VideoForm> video_forms() {
  return kForms;
}

const VideoForm* video_form_of(const std::filesystem::path& file) {
  const auto ending = lower_case(file.extension().string());
  const auto* const found = std::ranges::find(kForms, ending, &VideoForm::ending);
  return found == kForms.end() ? nullptr : found;
}

FrameRate rate_in(const VideoForm& form, const FrameRate& wanted) {
  if (!form.is_timed_in_hundredths) return wanted;
  constexpr std::int64_t kShortest = 2;
  constexpr std::int64_t kHundredths = 100;
  const auto each = std::max<std::int64_t>(
      kShortest, std::llround(static_cast<double>(kHundredths) / wanted.hertz().count()));
  return frame_rate_of(kHundredths, each);
}

}  // namespace bimodal
