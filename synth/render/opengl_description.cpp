#include "synth/render/opengl_description.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "synth/render/egl_context.hpp"

namespace bimodal::synth {

std::string opengl_description() {
  const EglContext context;
  const EglContext::Current current{context};
  const auto text = [](GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); };
  return fmt::format("{}, OpenGL {}", text(GL_RENDERER), text(GL_VERSION));
}

}  // namespace bimodal::synth
