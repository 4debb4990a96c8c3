#pragma once

#include <string>

#include <epoxy/egl.h>

namespace bimodal::synth {

/// An OpenGL 3.3 core context without window or surface, by EGL: Mesa's surfaceless platform, then
/// each EGL device, then the default display. Everything made in it (buffers, textures, programs)
/// is its own and goes with it; nothing needs to be deleted one by one. Used only by the thread
/// that made it; contexts in different threads do not disturb each other.
class EglContext {
 public:
  /// Throws Error saying what was tried and what to install.
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  EglContext(EglContext&&) = delete;
  EglContext& operator=(EglContext&&) = delete;

  /// Makes the context current while it lives, then brings back what was current before, so that
  /// drawing a head never disturbs a window's context in the same thread.
  class Current {
   public:
    explicit Current(const EglContext& context);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;
    Current(Current&&) = delete;
    Current& operator=(Current&&) = delete;

   private:
    EGLDisplay ours_;
    EGLDisplay display_before_;
    EGLContext context_before_;
    EGLSurface draw_before_;
    EGLSurface read_before_;
  };

 private:
  std::string open(EGLDisplay candidate);

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace bimodal::synth
