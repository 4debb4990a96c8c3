#pragma once

#include <string>
#include <vector>

#include "runner/cli/face_sheet.hpp"
#include "stimuli/timeline/account.hpp"
#include "stimuli/timeline/segment.hpp"
#include "synth/face/head.hpp"
#include "synth/render/head_renderer.hpp"
#include "synth/speech/articulation.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::runner {

/// Draws the mouth for contact sheets, from the front and from the side.
class SheetPainter {
 public:
  /// `segments`: the inventory's name or file; `height`: of a picture, in pixels. Throws Error if
  /// the inventory cannot be read or nothing can be drawn.
  SheetPainter(const std::string& segments, int height);

  /// The face that says `articulation`, at `time`.
  [[nodiscard]] SheetCell front(const synth::Articulation& articulation,
                                Milliseconds time,
                                std::string caption);
  [[nodiscard]] SheetCell side(const synth::Articulation& articulation,
                               Milliseconds time,
                               std::string caption);

  [[nodiscard]] synth::Articulation articulation(const std::vector<TimedSegment>& segments,
                                                 Account account = Account::Dominance) const;

 private:
  synth::SegmentTable table_;
  synth::Head head_;
  synth::HeadRenderer front_;
  synth::HeadRenderer side_;
};

}  // namespace bimodal::runner
