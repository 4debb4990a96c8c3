#pragma once

#include <memory>
#include <string>

#include "synth/face/head.hpp"
#include "synth/render/image.hpp"

namespace bimodal::synth {

/// From where and how the head is seen.
struct View {
  std::size_t width = 640;   ///< pixels
  std::size_t height = 720;  ///< pixels
  double yaw_deg = 0.0;      ///< camera round the head; positive shows the subject's left side
  double pitch_deg = 0.0;
  double centre_y_mm = -30.0;  ///< what stands in the middle of the picture
  double field_mm = 270.0;     ///< height of the picture at the head's centre
};

/// Draws the head into pictures with OpenGL 3.3 core, off-screen (EGL without a window). An
/// instance belongs to the thread that made it: it owns that thread's OpenGL context.
class HeadRenderer {
 public:
  /// Throws Error if OpenGL cannot be had, saying what to install. `head` must outlive the
  /// renderer.
  HeadRenderer(const Head& head, const View& view);
  ~HeadRenderer();
  HeadRenderer(const HeadRenderer&) = delete;
  HeadRenderer& operator=(const HeadRenderer&) = delete;
  HeadRenderer(HeadRenderer&&) = delete;
  HeadRenderer& operator=(HeadRenderer&&) = delete;

  /// The head at `pose`. `image` is reused: it keeps its memory.
  void draw(const Pose& pose, Image& image);

  /// GL_RENDERER and GL_VERSION, to be stored with the session.
  [[nodiscard]] std::string description() const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace bimodal::synth
