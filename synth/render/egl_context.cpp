#include "synth/render/egl_context.hpp"

#include <array>
#include <cassert>
#include <vector>

#include <dlfcn.h>
#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::synth {

namespace {

struct Candidate {
  std::string name;
  EGLDisplay display = EGL_NO_DISPLAY;
};

/// The library that loads OpenGL for us ends the program when libEGL is missing, so look first.
bool libegl_is_installed() {
  void* library = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) return false;
  dlclose(library);
  return true;
}

bool knows(const char* client_extension) {
  return epoxy_has_egl_extension(EGL_NO_DISPLAY, client_extension);
}

void add_devices(std::vector<Candidate>& candidates) {
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) == 0) return;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    candidates.push_back(
        {fmt::format("EGL device {}", i),
         eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices.at(i), nullptr)});
  }
}

std::vector<Candidate> displays_in_order_of_preference() {
  std::vector<Candidate> candidates;
  if (knows("EGL_EXT_platform_base")) {
    if (knows("EGL_MESA_platform_surfaceless")) {
      candidates.push_back(
          {"Mesa's surfaceless platform",
           eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)});
    }
    if (knows("EGL_EXT_platform_device") && knows("EGL_EXT_device_enumeration")) {
      add_devices(candidates);
    }
  }
  candidates.push_back({"the default display", eglGetDisplay(EGL_DEFAULT_DISPLAY)});
  return candidates;
}

std::string egl_failure(const char* call) {
  return fmt::format("{} failed (EGL error 0x{:04x})", call, eglGetError());
}

}  // namespace

EglContext::EglContext() {
  constexpr const char* kRemedy =
      "install the Debian packages libegl1 and libgl1-mesa-dri (apt-get install libegl1"
      " libgl1-mesa-dri)";
  if (!libegl_is_installed()) {
    throw Error{fmt::format("cannot draw the head: libEGL.so.1 is not installed; {}", kRemedy)};
  }
  std::string tried;
  for (const Candidate& candidate : displays_in_order_of_preference()) {
    const std::string failure = open(candidate.display);
    if (failure.empty()) return;
    tried += fmt::format("\n  {}: {}", candidate.name, failure);
  }
  throw Error{
      fmt::format("cannot draw the head: no OpenGL 3.3 by EGL; {}. Tried:{}", kRemedy, tried)};
}

/// Empty if the context now exists on `candidate`, else what went wrong.
std::string EglContext::open(EGLDisplay candidate) {
  if (candidate == EGL_NO_DISPLAY) return "there is no such display";
  EGLint major = 0;
  EGLint minor = 0;
  if (eglInitialize(candidate, &major, &minor) == 0) return egl_failure("eglInitialize");
  if (!epoxy_has_egl_extension(candidate, "EGL_KHR_surfaceless_context")) {
    return fmt::format("EGL {}.{} without EGL_KHR_surfaceless_context", major, minor);
  }
  if (eglBindAPI(EGL_OPENGL_API) == 0) return egl_failure("eglBindAPI");
  constexpr EGLint kNoSurfaceNeeded = 0;  // left out, EGL would want configurations for windows
  constexpr std::array<EGLint, 5> kAnyOpenGl{
      EGL_SURFACE_TYPE, kNoSurfaceNeeded, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint configs = 0;
  if (eglChooseConfig(candidate, kAnyOpenGl.data(), &config, 1, &configs) == 0 || configs == 0) {
    return egl_failure("eglChooseConfig");
  }
  constexpr std::array<EGLint, 7> kCore33{EGL_CONTEXT_MAJOR_VERSION,
                                          3,
                                          EGL_CONTEXT_MINOR_VERSION,
                                          3,
                                          EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                          EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                          EGL_NONE};
  EGLContext context = eglCreateContext(candidate, config, EGL_NO_CONTEXT, kCore33.data());
  if (context == EGL_NO_CONTEXT) return egl_failure("eglCreateContext for OpenGL 3.3 core");
  display_ = candidate;
  context_ = context;
  return {};
}

// The display is shared by all contexts of the process, so it is never terminated here.
EglContext::~EglContext() {
  eglDestroyContext(display_, context_);
}

EglContext::Current::Current(const EglContext& context)
    : ours_{context.display_},
      display_before_{eglGetCurrentDisplay()},
      context_before_{eglGetCurrentContext()},
      draw_before_{eglGetCurrentSurface(EGL_DRAW)},
      read_before_{eglGetCurrentSurface(EGL_READ)} {
  eglBindAPI(EGL_OPENGL_API);
  if (eglMakeCurrent(context.display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context.context_) == 0) {
    throw Error{
        fmt::format("cannot draw the head: {}; a renderer belongs to the thread that made it",
                    egl_failure("eglMakeCurrent"))};
  }
}

EglContext::Current::~Current() {
  if (context_before_ == EGL_NO_CONTEXT) {
    eglMakeCurrent(ours_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  } else {
    eglMakeCurrent(display_before_, draw_before_, read_before_, context_before_);
  }
}

}  // namespace bimodal::synth
