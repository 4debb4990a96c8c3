#pragma once

#include <memory>
#include <span>
#include <string>

#include "runner/preparation/frame_source.hpp"
#include "stimuli/timeline/account.hpp"
#include "stimuli/timeline/segment.hpp"
#include "synth/render/head_renderer.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::runner {

/// The synthetic face as a talker: head and drawing. Belongs to the thread that made
/// it.
class FaceTalker {
 public:
  /// Distance of the outer eye corners, in parts of the picture's height: 90 of 312 mm.
  static constexpr double kEyeDistance = 90.0 / 312.0;

  /// A face `height` pixels high (its picture is 8/9 as wide) before `background` (0xRRGGBB).
  FaceTalker(std::size_t height, std::uint32_t background, synth::Quality quality);

  /// The face articulating `segments` as `table` and `account` say. Must not outlive the talker.
  [[nodiscard]] std::unique_ptr<FrameSource> say(std::span<const TimedSegment> segments,
                                                 const synth::SegmentTable& table,
                                                 Account account);

  /// The OpenGL that draws it.
  [[nodiscard]] std::string description() const { return renderer_.description(); }

 private:
  synth::Head head_;
  synth::HeadRenderer renderer_;
};

}  // namespace bimodal::runner
