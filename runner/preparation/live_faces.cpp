#include "runner/preparation/live_faces.hpp"

#include <algorithm>
#include <utility>

#include "stimuli/base/asset.hpp"

namespace bimodal::runner {

namespace {

/// Looks that are equal in it are drawn alike: height, blur and frame rate come after drawing.
ShownLook as_drawn(const ShownLook& look) {
  return {.height = look.lines,
          .lines = look.lines,
          .frame_rate = std::nullopt,
          .background = look.background,
          .face = at_rest(look.face)};
}

}  // namespace

FaceTalker& LiveFaces::face(const ShownLook& look) {
  auto drawn = as_drawn(look);
  const auto found = std::ranges::find(faces_, drawn, &Live::drawn);
  if (found != faces_.end()) {
    std::rotate(faces_.begin(), found, found + 1);
    return *faces_.front().talker;
  }
  if (!head_) head_.emplace(asset("synth/assets/head"));
  if (faces_.size() >= most_) faces_.pop_back();
  auto talker = std::make_unique<FaceTalker>(*head_, drawn, quality_);
  faces_.insert(faces_.begin(), Live{std::move(drawn), std::move(talker)});
  return *faces_.front().talker;
}

}  // namespace bimodal::runner
