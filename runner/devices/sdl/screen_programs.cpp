#include "runner/devices/sdl/screen_programs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "runner/devices/device_error.hpp"

namespace bimodal::runner {

namespace {

constexpr const char* kVertexShader = R"(#version 330 core
layout(location = 0) in vec2 place;
layout(location = 1) in vec2 part;
uniform vec2 window;
out vec2 at;
void main() {
  at = part;
  gl_Position = vec4(place.x / window.x * 2.0 - 1.0, 1.0 - place.y / window.y * 2.0, 0.0, 1.0);
})";

constexpr const char* kPictureShader = R"(#version 330 core
in vec2 at;
uniform sampler2D image;
out vec4 colour;
void main() { colour = vec4(texture(image, at).rgb, 1.0); })";

constexpr const char* kInkShader = R"(#version 330 core
in vec2 at;
uniform vec3 ink;
uniform sampler2D coverage;
out vec4 colour;
void main() { colour = vec4(ink, texture(coverage, at).r); })";

constexpr int kDiscPixels = 256;  ///< of the texture, scaled to what is wanted

GLuint compiled(GLenum kind, const char* source) {
  const auto shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint done = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done != GL_TRUE) {
    std::array<char, 512> log{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw DeviceError{fmt::format(
        "display: the OpenGL driver refuses a shader: {}; OpenGL 3.3 is needed", log.data())};
  }
  return shader;
}

GLuint linked_program(const char* fragment_shader) {
  const auto program = glCreateProgram();
  for (const auto shader :
       {compiled(GL_VERTEX_SHADER, kVertexShader), compiled(GL_FRAGMENT_SHADER, fragment_shader)}) {
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(program);
  GLint done = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &done);
  if (done != GL_TRUE) throw DeviceError{"display: the OpenGL driver cannot link the shaders"};
  return program;
}

}  // namespace

GLuint linked_picture_program() {
  return linked_program(kPictureShader);
}

GLuint linked_ink_program() {
  return linked_program(kInkShader);
}

GLuint new_texture() {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

GLuint disc_texture() {
  std::vector<std::uint8_t> coverage;
  coverage.reserve(static_cast<std::size_t>(kDiscPixels) * kDiscPixels);
  constexpr double kMiddle = (kDiscPixels - 1) / 2.0;
  for (int y = 0; y < kDiscPixels; ++y) {
    for (int x = 0; x < kDiscPixels; ++x) {
      const double inside = (kDiscPixels / 2.0 - std::hypot(x - kMiddle, y - kMiddle)) / 2.0;
      coverage.push_back(static_cast<std::uint8_t>(255.0 * std::clamp(inside, 0.0, 1.0)));
    }
  }
  const auto texture = new_texture();
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D,
               0,
               GL_R8,
               kDiscPixels,
               kDiscPixels,
               0,
               GL_RED,
               GL_UNSIGNED_BYTE,
               coverage.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  return texture;
}

}  // namespace bimodal::runner
