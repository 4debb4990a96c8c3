#include "synth/render/shader.hpp"

#include <array>
#include <fstream>
#include <iterator>
#include <vector>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::synth {

namespace {

std::string text_of(std::string_view name) {
  const auto file = asset(fmt::format("synth/assets/shaders/{}", name));
  std::ifstream in{file, std::ios::binary};
  std::string text{std::istreambuf_iterator<char>{in}, {}};
  if (!in || text.empty()) throw Error{fmt::format("cannot read the shader '{}'", file.string())};
  return text;
}

template <typename Parameter, typename Log>
std::string log_of(GLuint object, Parameter parameter_of, Log log_into) {
  GLint length = 0;
  parameter_of(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  log_into(object, length, nullptr, log.data());
  return log;
}

GLuint compile(GLenum stage,
               std::initializer_list<std::string_view> files,
               std::string_view definition,
               std::string_view preamble) {
  std::string text = "#version 330 core\n";
  if (!definition.empty()) text += fmt::format("#define {} 1\n", definition);
  text += preamble;
  std::string legend;
  int number = 1;
  for (const std::string_view file : files) {
    text += fmt::format("#line 1 {}\n{}\n", number, text_of(file));
    legend += fmt::format("\n  {} is {}", number, file);
    ++number;
  }
  const GLuint shader = glCreateShader(stage);
  const char* pointer = text.c_str();
  glShaderSource(shader, 1, &pointer, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_FALSE) {
    throw Error{fmt::format("cannot compile a shader, in whose log{}\n{}",
                            legend,
                            log_of(shader, glGetShaderiv, glGetShaderInfoLog))};
  }
  return shader;
}

}  // namespace

Program::Program(const ShaderSource& source) : name_{glCreateProgram()} {
  for (const GLuint shader :
       {compile(GL_VERTEX_SHADER, source.vertex, "", source.preamble),
        compile(GL_FRAGMENT_SHADER, source.fragment, source.definition, source.preamble)}) {
    glAttachShader(name_, shader);
    glDeleteShader(shader);  // the program keeps it
  }
  glLinkProgram(name_);
  GLint linked = GL_FALSE;
  glGetProgramiv(name_, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) {
    throw Error{fmt::format("cannot link a shader program: {}",
                            log_of(name_, glGetProgramiv, glGetProgramInfoLog))};
  }
}

void Program::set(const char* uniform, float value) const {
  glUniform1f(glGetUniformLocation(name_, uniform), value);
}

void Program::set(const char* uniform, const glm::vec3& value) const {
  glUniform3fv(glGetUniformLocation(name_, uniform), 1, glm::value_ptr(value));
}

void Program::set(const char* uniform, const glm::vec4& value) const {
  glUniform4fv(glGetUniformLocation(name_, uniform), 1, glm::value_ptr(value));
}

void Program::set(const char* uniform, const glm::mat3& value) const {
  glUniformMatrix3fv(glGetUniformLocation(name_, uniform), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(const char* uniform, const glm::mat4& value) const {
  glUniformMatrix4fv(glGetUniformLocation(name_, uniform), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace bimodal::synth
