#include "runner/cli/sheet_painter.hpp"

#include <utility>

#include "runner/cli/face_view.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/timeline/inventory_file.hpp"

namespace bimodal::runner {

namespace {

ViewOptions mouth(int height) {
  ViewOptions options;
  options.view = "mouth";
  options.height = height;
  return options;
}

/// The mouth in profile, with the lips in the middle.
ViewOptions mouth_in_profile(int height) {
  auto options = mouth(height);
  options.yaw_deg = 90;
  options.centre_mm = {0, -70, 75};
  return options;
}

SheetCell cell(synth::HeadRenderer& renderer, const synth::Pose& pose, std::string caption) {
  SheetCell made{.picture = {}, .caption = std::move(caption)};
  renderer.draw(pose, made.picture);
  return made;
}

}  // namespace

SheetPainter::SheetPainter(const std::string& segments, int height)
    : table_{inventory_file(segments)},
      head_{asset("synth/assets/head")},
      front_{head_, face_view(mouth(height))},
      side_{head_, face_view(mouth_in_profile(height))} {}

SheetCell SheetPainter::front(const synth::Articulation& articulation,
                              Milliseconds time,
                              std::string caption) {
  return cell(front_, articulation.at(time), std::move(caption));
}

SheetCell SheetPainter::side(const synth::Articulation& articulation,
                             Milliseconds time,
                             std::string caption) {
  return cell(side_, articulation.at(time), std::move(caption));
}

synth::Articulation SheetPainter::articulation(const std::vector<TimedSegment>& segments,
                                               Account account) const {
  return {segments, table_, account};
}

}  // namespace bimodal::runner
