#include "runner/preparation/shown_look.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "protocols/model/talker.hpp"
#include "runner/preparation/face_talker.hpp"
#include "runner/preparation/view_names.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/picture/resize.hpp"
#include "stimuli/video/frame_reader.hpp"
#include "stimuli/video/media_file.hpp"

namespace bimodal::runner {

namespace {

/// The mean colour of squares in the upper corners, a twelfth of the picture's height wide.
std::uint32_t corner_colour(const Image& image) {
  const std::size_t side = std::max<std::size_t>(1, std::min(image.width, image.height) / 12);
  std::array<double, 3> sum{};
  for (std::size_t y = 0; y < side; ++y) {
    for (std::size_t x = 0; x < side; ++x) {
      for (const std::size_t column : {x, image.width - 1 - x}) {
        const auto* const pixel = &image.pixels[(y * image.width + column) * 4];
        for (std::size_t channel = 0; channel < 3; ++channel) {
          sum[channel] += static_cast<double>(pixel[channel]);
        }
      }
    }
  }
  std::uint32_t colour = 0;
  for (const double channel : sum) {
    const auto mean = std::lround(channel / static_cast<double>(2 * side * side));
    colour = colour << 8U | static_cast<std::uint32_t>(mean);
  }
  return colour;
}

PictureNature nature_of_corpus(const Corpus& corpus) {
  if (corpus.items.empty()) {
    throw Error{fmt::format("the corpus \"{}\" has no item to take a look from", corpus.name)};
  }
  const auto& item = corpus.items.front();
  const auto file = media_file(corpus, item.recording);
  const auto media = examine_media(file);
  if (!media.picture) {
    throw Error{fmt::format("'{}' has no picture to take a look from", file.string())};
  }
  PictureNature nature{.frame_rate_hz = media.picture->frame_rate.count(),
                       .lines = media.picture->height,
                       .eye_distance = std::nullopt,
                       .background = std::nullopt};
  if (const auto eyes = corpus.recordings.at(item.recording).eye_distance_px) {
    nature.eye_distance = *eyes / static_cast<double>(media.picture->height);
  }
  FrameReader reader{file, {.height = 0, .span = {item.start, item.end}}};
  if (const auto frame = reader.next()) nature.background = corner_colour(frame->image);
  return nature;
}

/// Frames that change seldom, at another size.
class LookedSource final : public FrameSource {
 public:
  LookedSource(std::unique_ptr<FrameSource> source, const ShownLook& look)
      : source_{std::move(source)}, look_{look} {}

  [[nodiscard]] std::int64_t picture_at(Duration time) override {
    return source_->picture_at(held(time));
  }

  [[nodiscard]] std::shared_ptr<const Image> paint(Duration time) override {
    auto image = source_->paint(held(time));
    if (image->height != look_.height) {
      const auto width = static_cast<std::size_t>(
          std::lround(static_cast<double>(image->width) * static_cast<double>(look_.height) /
                      static_cast<double>(image->height)));
      image = std::make_shared<const Image>(
          resized(*image, std::max<std::size_t>(1, width), look_.height));
    }
    if (look_.blur_px > 0.0) image = std::make_shared<const Image>(blurred(*image, look_.blur_px));
    return image;
  }

  [[nodiscard]] std::optional<std::int64_t> source_frame(std::int64_t number) const override {
    return source_->source_frame(number);
  }

 private:
  /// When a camera of the look's frame rate last looked; a microsecond forgives rounding.
  [[nodiscard]] Duration held(Duration time) const {
    if (!look_.frame_rate) return time;
    constexpr double kForgiven = 1e-6;
    const double seconds = std::chrono::duration<double>{time}.count() + kForgiven;
    const double frame = std::floor(seconds * look_.frame_rate->count());
    return Duration{std::llround(1e9 * frame / look_.frame_rate->count())};
  }

  std::unique_ptr<FrameSource> source_;
  ShownLook look_;
};

std::size_t pixels(double number) {
  return static_cast<std::size_t>(std::max(1L, std::lround(number)));
}

}  // namespace

PictureNature nature_of(const std::string& talker, const std::map<std::string, Corpus>& corpora) {
  if (!protocols::is_corpus(talker)) {
    return {.frame_rate_hz = 0.0,
            .lines = 0,
            .eye_distance = FaceTalker::kEyeDistance,
            .background = std::nullopt};
  }
  const auto found = corpora.find(protocols::corpus_name(talker));
  if (found == corpora.end()) throw Error{fmt::format("there is no '{}'", talker)};
  return nature_of_corpus(found->second);
}

ShownLook decide_look(const protocols::Condition& condition,
                      const protocols::Window& window,
                      const std::map<std::string, Corpus>& corpora) {
  const auto& wanted = condition.look;
  const auto whole = static_cast<std::size_t>(window.face_height);
  const bool is_face = condition.visual_talker && !protocols::is_corpus(*condition.visual_talker);
  ShownLook look{.height = wanted.height ? static_cast<std::size_t>(*wanted.height) : whole,
                 .lines = 0,
                 .frame_rate = wanted.frame_rate,
                 .blur_px = wanted.blur_px,
                 .background = wanted.background.value_or(window.background),
                 .face = is_face ? condition.face : protocols::Face{}};
  if (!wanted.like.empty()) {
    auto own = nature_of(*condition.visual_talker, corpora);
    if (!shows_whole_head(look.face.view)) own.eye_distance.reset();
    const auto other = nature_of(wanted.like, corpora);
    // The other is shown at the window's height.
    if (!wanted.height && own.eye_distance && other.eye_distance) {
      look.height = pixels(static_cast<double>(whole) * *other.eye_distance / *own.eye_distance);
    }
    if (!wanted.frame_rate && other.frame_rate_hz > 0.0) {
      look.frame_rate = Hertz{other.frame_rate_hz};
    }
    if (!wanted.background && other.background) look.background = *other.background;
    if (other.lines > 0) {
      look.lines = pixels(static_cast<double>(look.height) * static_cast<double>(other.lines) /
                          static_cast<double>(whole));
    }
  }
  if (wanted.lines) look.lines = static_cast<std::size_t>(*wanted.lines);
  if (look.lines == 0 || look.lines > look.height) look.lines = look.height;
  return look;
}

std::unique_ptr<FrameSource> with_look(std::unique_ptr<FrameSource> source, const ShownLook& look) {
  return std::make_unique<LookedSource>(std::move(source), look);
}

}  // namespace bimodal::runner
