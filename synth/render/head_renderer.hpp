#pragma once

#include <memory>
#include <string>

#include "stimuli/picture/image.hpp"
#include "synth/face/head.hpp"
#include "synth/render/appearance.hpp"
#include "synth/render/view.hpp"

namespace bimodal::synth {

/// Draws the head into pictures with OpenGL 3.3 core, off-screen (EGL without a window). An
/// instance belongs to the thread that made it; it has an OpenGL context of its own, so that any
/// number of threads can have one each.
class HeadRenderer {
 public:
  /// Throws Error if OpenGL cannot be had, saying what to install. `head` must outlive the
  /// renderer.
  HeadRenderer(const Head& head, const View& view, const Appearance& appearance = {});
  ~HeadRenderer();
  HeadRenderer(const HeadRenderer&) = delete;
  HeadRenderer& operator=(const HeadRenderer&) = delete;
  HeadRenderer(HeadRenderer&&) = delete;
  HeadRenderer& operator=(HeadRenderer&&) = delete;

  /// The head at `pose`. `image` is reused: it keeps its memory. The same pose gives the same bytes
  /// on the same machine and driver.
  void draw(const Pose& pose, Image& image);

  /// GL_RENDERER and GL_VERSION, to be stored with the session.
  [[nodiscard]] std::string description() const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace bimodal::synth
