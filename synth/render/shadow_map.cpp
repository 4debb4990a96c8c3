#include "synth/render/shadow_map.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace bimodal::synth {

namespace {

constexpr GLsizei kSize = 1024;  // texels; 0.36 mm each
constexpr float kHalf = 185.0F;  // mm seen from the centre; shadow.glsl knows it too
constexpr glm::vec3 kCentre{0.0F, -20.0F, 10.0F};

}  // namespace

ShadowMap::ShadowMap(const glm::vec3& towards) : program_{{{"depth.vert"}, {"depth.frag"}}} {
  clip_from_world_ = glm::ortho(-kHalf, kHalf, -kHalf, kHalf, 0.0F, 2.0F * kHalf) *
                     glm::lookAt(kCentre + kHalf * towards, kCentre, glm::vec3{0.0F, 1.0F, 0.0F});
  map_from_world_ = glm::translate(glm::mat4{1.0F}, glm::vec3{0.5F}) *
                    glm::scale(glm::mat4{1.0F}, glm::vec3{0.5F}) * clip_from_world_;
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexImage2D(GL_TEXTURE_2D,
               0,
               GL_DEPTH_COMPONENT32F,
               kSize,
               kSize,
               0,
               GL_DEPTH_COMPONENT,
               GL_FLOAT,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_, 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  program_.use();
  program_.set("clip_from_world", clip_from_world_);
}

void ShadowMap::draw(const MeshBuffers& mesh, const PartSet& casters) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, kSize, kSize);
  glClear(GL_DEPTH_BUFFER_BIT);
  program_.use();
  for (std::size_t part = 0; part < kHeadPartCount; ++part) {
    if (casters[part]) mesh.draw(static_cast<HeadPart>(part), MeshBuffers::Side::Both);
  }
  glBindTexture(GL_TEXTURE_2D, texture_);
}

}  // namespace bimodal::synth
