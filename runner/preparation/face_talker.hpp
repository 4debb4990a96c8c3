#pragma once

#include <memory>
#include <span>
#include <string>

#include "runner/preparation/drawn_face.hpp"
#include "runner/preparation/frame_source.hpp"
#include "runner/preparation/shown_look.hpp"
#include "stimuli/timeline/account.hpp"
#include "stimuli/timeline/segment.hpp"
#include "synth/render/head_renderer.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::runner {

/// The synthetic face as a talker: what draws the head in one look. Belongs to the thread that made
/// it.
class FaceTalker {
 public:
  /// Distance of the outer eye corners, in parts of the height of a picture of the whole head.
  static constexpr double kEyeDistance = 90.0 / kWholeHead;

  /// A face `look.lines` pixels high (its picture is 8/9 as wide). `head` is borrowed.
  FaceTalker(const synth::Head& head, const ShownLook& look, synth::Quality quality);

  /// The face articulating `segments` as `table` and `account` say, in this bearing. Must not
  /// outlive the talker.
  [[nodiscard]] std::unique_ptr<FrameSource> say(std::span<const TimedSegment> segments,
                                                 const synth::SegmentTable& table,
                                                 Account account,
                                                 Bearing bearing = {});

  /// The OpenGL that draws it.
  [[nodiscard]] std::string description() const { return renderer_.description(); }

 private:
  synth::HeadRenderer renderer_;
};

}  // namespace bimodal::runner
