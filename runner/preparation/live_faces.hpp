#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "runner/preparation/face_talker.hpp"
#include "runner/preparation/shown_look.hpp"
#include "synth/face/head.hpp"

namespace bimodal::runner {

/// The faces that can be drawn at once. A face keeps its look as long as it lives, and takes memory
/// (about 80 MB where OpenGL is software): it is made when it is needed, and the one that has not
/// been needed for longest gives way to it. Belongs to one thread.
class LiveFaces {
 public:
  static constexpr std::size_t kMost = 4;

  explicit LiveFaces(synth::Quality quality, std::size_t most = kMost)
      : quality_{quality}, most_{most} {}

  /// The face of this look, whatever its bearing. Valid until the next call. Throws Error if it
  /// cannot be drawn.
  [[nodiscard]] FaceTalker& face(const ShownLook& look);

  [[nodiscard]] std::size_t count() const { return faces_.size(); }

 private:
  struct Live {
    ShownLook drawn;  ///< what of a look the drawing depends on
    std::unique_ptr<FaceTalker> talker;
  };

  synth::Quality quality_;
  std::size_t most_;
  std::optional<synth::Head> head_;  ///< of all; made with the first
  std::vector<Live> faces_;          ///< the one that was used last stands first
};

}  // namespace bimodal::runner
