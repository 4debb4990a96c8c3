#include "runner/booth/patch.hpp"

#include <fmt/format.h>

namespace bimodal::runner {

namespace {

using protocols::Corner;
using protocols::Photodiode;
using protocols::Polarity;

constexpr std::array<float, 3> kBlack{0.0F, 0.0F, 0.0F};
constexpr std::array<float, 3> kWhite{1.0F, 1.0F, 1.0F};

std::string place_of(const Photodiode& photodiode) {
  if (photodiode.centre) {
    return fmt::format(
        "around ({:g}, {:g}) of the window", (*photodiode.centre)[0], (*photodiode.centre)[1]);
  }
  switch (photodiode.corner) {
    case Corner::UpperLeft:
      return "in the upper left corner";
    case Corner::UpperRight:
      return "in the upper right corner";
    case Corner::LowerLeft:
      return "in the lower left corner";
    case Corner::LowerRight:
      return "in the lower right corner";
  }
  return "nowhere";
}

}  // namespace

Patch patch_of(const Photodiode& photodiode, int width, int height) {
  const auto box = protocols::patch_box(photodiode, width, height);
  // Halves are rounded down here as where marks are drawn, so that the pixels come out exactly.
  const int centre_x = box.left + box.width / 2;
  const int centre_y = box.top + box.height / 2;
  Mark mark{.shape = Mark::Shape::Box,
            .centre_x = static_cast<double>(centre_x) / width,
            .centre_y = static_cast<double>(centre_y) / height,
            .width = static_cast<double>(box.width) / width,
            .height = static_cast<double>(box.height) / height};
  const bool lights_up = photodiode.polarity == Polarity::WhiteOnBlack;
  Patch patch{.at_rest = mark, .at_zero = mark, .length = photodiode.length};
  patch.at_rest.colour = lights_up ? kBlack : kWhite;
  patch.at_zero.colour = lights_up ? kWhite : kBlack;
  patch.described = fmt::format("{} pixels {}, {}",
                                photodiode.size,
                                place_of(photodiode),
                                lights_up ? "white on black" : "black on white");
  return patch;
}

ZeroCue::ZeroCue(const PreparedTrial& trial, const CueSheet& cues)
    : cues_{cues},
      has_picture_{trial.frames > 0},
      zero_frame_{lead_frames(trial.layout, trial.drawing_rate)} {}

bool ZeroCue::is_next(Instant due, std::optional<std::int64_t> frame, Duration period) const {
  if (passed_) return false;
  if (has_picture_) return frame && *frame >= zero_frame_;
  return due + period / 2 > cues_.auditory_zero();
}

}  // namespace bimodal::runner
