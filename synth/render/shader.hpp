#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include <epoxy/gl.h>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace bimodal::synth {

/// The files of a program in synth/assets/shaders; each stage is their texts one after the other.
struct ShaderSource {
  std::initializer_list<std::string_view> vertex;
  std::initializer_list<std::string_view> fragment;
  std::string_view definition = "";  ///< what is #defined in the fragment stage; may be empty
  std::string_view preamble = "";    ///< GLSL before the files of both stages
};

/// A compiled OpenGL program; it lives as long as the context that is current at construction.
class Program {
 public:
  /// Throws Error with the driver's log, in which "2:14" is line 14 of the named file.
  explicit Program(const ShaderSource& source);

  void use() const { glUseProgram(name_); }

  /// For the program in use. A uniform that the compiler left out is ignored.
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::vec3& value) const;
  void set(const char* uniform, const glm::vec4& value) const;
  void set(const char* uniform, const glm::mat3& value) const;
  void set(const char* uniform, const glm::mat4& value) const;

 private:
  GLuint name_ = 0;
};

}  // namespace bimodal::synth
