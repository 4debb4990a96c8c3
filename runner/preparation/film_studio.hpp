#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "protocols/model/protocol.hpp"
#include "runner/preparation/enactment.hpp"
#include "runner/preparation/face_talker.hpp"
#include "runner/preparation/frame_source.hpp"
#include "runner/preparation/shown_look.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::runner {

/// Makes the films of a protocol's trials: lets the face or the natural talker act, in the look
/// that the condition asks for. Belongs to one thread (its faces own OpenGL contexts).
class FilmStudio {
 public:
  /// Both are borrowed.
  FilmStudio(const protocols::Window& window, const std::map<std::string, Corpus>& corpora)
      : window_{window}, corpora_{corpora} {}

  /// Throws Error if the talker cannot be drawn or decoded.
  [[nodiscard]] Film film(const protocols::Condition& condition,
                          const Enactment& enactment,
                          const StimulusLayout& layout,
                          Hertz drawing_rate,
                          const Checkpoint& checkpoint);

  /// Decided once for each condition.
  [[nodiscard]] const ShownLook& look_of(const protocols::Condition& condition);

 private:
  [[nodiscard]] FaceTalker& face(const ShownLook& look);
  [[nodiscard]] const synth::SegmentTable& table(const std::string& file);

  const protocols::Window& window_;
  const std::map<std::string, Corpus>& corpora_;
  std::map<std::pair<std::size_t, std::uint32_t>, std::unique_ptr<FaceTalker>> faces_;
  std::map<std::string, synth::SegmentTable> tables_;  ///< by their files
  std::map<std::string, ShownLook> looks_;             ///< by the condition's name
};

}  // namespace bimodal::runner
