#include "synth/render/picture_target.hpp"

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::synth {

namespace {

void attach(GLenum attachment, GLenum format, const Image& picture) {
  GLuint renderbuffer = 0;
  glGenRenderbuffers(1, &renderbuffer);
  glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  glRenderbufferStorage(GL_RENDERBUFFER,
                        format,
                        static_cast<GLsizei>(picture.width),
                        static_cast<GLsizei>(picture.height));
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
}

}  // namespace

PictureTarget::PictureTarget(std::size_t width, std::size_t height)
    : raw_{width, height, std::vector<std::uint8_t>(width * height * 4)} {
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  attach(GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8, raw_);
  attach(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, raw_);
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  throw Error{fmt::format(
      "cannot draw pictures of {} x {} pixels (OpenGL framebuffer status 0x{:04x}); choose a"
      " smaller size",
      width,
      height,
      status)};
}

void PictureTarget::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, static_cast<GLsizei>(raw_.width), static_cast<GLsizei>(raw_.height));
  glEnable(GL_FRAMEBUFFER_SRGB);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void PictureTarget::read_into(Image& image) {
  glReadPixels(0,
               0,
               static_cast<GLsizei>(raw_.width),
               static_cast<GLsizei>(raw_.height),
               GL_RGBA,
               GL_UNSIGNED_BYTE,
               raw_.pixels.data());
  smoothing_.apply(raw_, image);
}

}  // namespace bimodal::synth
