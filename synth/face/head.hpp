#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "synth/face/surface.hpp"
#include "synth/speech/control.hpp"

namespace bimodal::synth {

/// The project's own head: control cage, displacement fields, contacts, subdivision. Immutable
/// after construction; pose() may be called from several threads, each with its own PosedHead.
class Head {
 public:
  /// Reads synth/assets/head (cage, fields). Throws Error, naming file and line.
  explicit Head(const std::filesystem::path& folder);
  ~Head();
  Head(Head&& other) noexcept;
  Head& operator=(Head&& other) noexcept;
  Head(const Head&) = delete;
  Head& operator=(const Head&) = delete;

  [[nodiscard]] std::span<const SurfaceDescription> surfaces() const;

  /// Moves every surface to `wanted`; controls are clamped to their ranges.
  void pose(const Pose& wanted, PosedHead& posed) const;

 private:
  struct Rig;
  std::shared_ptr<const Rig> rig_;  // a PosedHead remembers it
};

}  // namespace bimodal::synth
