#pragma once

#include <memory>
#include <span>
#include <string>

#include <glm/mat3x3.hpp>

#include "stimuli/picture/image.hpp"
#include "synth/face/surface.hpp"
#include "synth/render/appearance.hpp"
#include "synth/render/egl_context.hpp"
#include "synth/render/view.hpp"

namespace bimodal::synth {

/// Draws posed surfaces into pictures; knows nothing of controls. Belongs to the thread that made
/// it. The same surfaces give the same bytes every time on the same machine and driver.
class SurfaceRenderer {
 public:
  /// `resting` is the pose in which the shadows that the head casts on itself are worked out, once.
  /// Throws Error if OpenGL cannot be had.
  SurfaceRenderer(std::span<const SurfaceDescription> surfaces,
                  const PosedHead& resting,
                  const View& view,
                  const Appearance& appearance = {});
  ~SurfaceRenderer();
  SurfaceRenderer(const SurfaceRenderer&) = delete;
  SurfaceRenderer& operator=(const SurfaceRenderer&) = delete;
  SurfaceRenderer(SurfaceRenderer&&) = delete;
  SurfaceRenderer& operator=(SurfaceRenderer&&) = delete;

  /// `head_axes`: columns are the head's left, up and forward in the room. `image` keeps its
  /// memory.
  void draw(const PosedHead& posed, const glm::mat3& head_axes, Image& image);

  /// GL_RENDERER and GL_VERSION.
  [[nodiscard]] std::string description() const;

 private:
  struct Stage;
  EglContext context_;
  std::unique_ptr<Stage> stage_;
};

}  // namespace bimodal::synth
