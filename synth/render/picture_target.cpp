#include "synth/render/picture_target.hpp"

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::synth {

namespace {

void attach(GLenum attachment, GLenum format, const Image& picture, int samples) {
  GLuint renderbuffer = 0;
  glGenRenderbuffers(1, &renderbuffer);
  glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER,
                                   samples > 1 ? samples : 0,
                                   format,
                                   static_cast<GLsizei>(picture.width),
                                   static_cast<GLsizei>(picture.height));
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
}

GLuint framebuffer(const Image& picture, int samples) {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  attach(GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8, picture, samples);
  attach(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, picture, samples);
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return name;
  throw Error{fmt::format(
      "cannot draw pictures of {} x {} pixels (OpenGL framebuffer status 0x{:04x}); choose a"
      " smaller size",
      picture.width,
      picture.height,
      status)};
}

}  // namespace

PictureTarget::PictureTarget(std::size_t width, std::size_t height, int samples)
    : samples_{samples}, raw_{width, height, std::vector<std::uint8_t>(width * height * 4)} {
  framebuffer_ = framebuffer(raw_, samples);
  single_ = samples > 1 ? framebuffer(raw_, 1) : framebuffer_;
}

void PictureTarget::begin_ground() {
  ground_ = framebuffer(raw_, samples_);
  glViewport(0, 0, static_cast<GLsizei>(raw_.width), static_cast<GLsizei>(raw_.height));
  glEnable(GL_FRAMEBUFFER_SRGB);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void PictureTarget::begin() const {
  const auto width = static_cast<GLsizei>(raw_.width);
  const auto height = static_cast<GLsizei>(raw_.height);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, width, height);
  glEnable(GL_FRAMEBUFFER_SRGB);
  if (ground_ == 0) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    return;
  }
  glBindFramebuffer(GL_READ_FRAMEBUFFER, ground_);
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void PictureTarget::read_into(Image& image) {
  const auto width = static_cast<GLsizei>(raw_.width);
  const auto height = static_cast<GLsizei>(raw_.height);
  const bool has_samples = single_ != framebuffer_;
  if (has_samples) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, single_);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, single_);
  }
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, raw_.pixels.data());
  if (has_samples) {
    image = raw_;
  } else {
    smoothing_.apply(raw_, image);
  }
}

}  // namespace bimodal::synth
