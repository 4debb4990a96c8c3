#include "synth/render/picture_target.hpp"

#include <cstdlib>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::synth {

namespace {
GLsizei samples_wanted() {
  const char* s = std::getenv("RDEV_SAMPLES");
  return s ? std::atoi(s) : 4;
}

void attach(GLenum attachment, GLenum format, GLsizei samples, GLsizei width, GLsizei height) {
  GLuint renderbuffer = 0;
  glGenRenderbuffers(1, &renderbuffer);
  glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
}

GLuint new_framebuffer() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  return name;
}

void check_framebuffer(std::size_t width, std::size_t height) {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  throw Error{fmt::format(
      "cannot draw pictures of {} x {} pixels: OpenGL framebuffer status 0x{:04x}; make the"
      " picture smaller",
      width,
      height,
      status)};
}

}  // namespace

PictureTarget::PictureTarget(std::size_t width, std::size_t height)
    : width_{width}, height_{height} {
  const auto w = static_cast<GLsizei>(width);
  const auto h = static_cast<GLsizei>(height);
  samples_ = new_framebuffer();
  attach(GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8, samples_wanted(), w, h);
  attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, samples_wanted(), w, h);
  check_framebuffer(width, height);
  picture_ = new_framebuffer();
  attach(GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8, 0, w, h);
  check_framebuffer(width, height);
}

void PictureTarget::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, samples_);
  glViewport(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_));
  glEnable(GL_FRAMEBUFFER_SRGB);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void PictureTarget::read_into(Image& image) const {
  const auto w = static_cast<GLsizei>(width_);
  const auto h = static_cast<GLsizei>(height_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture_);
  glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture_);
  image.width = width_;
  image.height = height_;
  image.pixels.resize(width_ * height_ * 4);
  glReadPixels(0, 0, w, h, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
}

}  // namespace bimodal::synth
