#include "synth/render/head_renderer.hpp"

#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "synth/render/surface_renderer.hpp"

namespace bimodal::synth {

namespace {

PosedHead posed(const Head& head, const Pose& pose) {
  PosedHead result;
  head.pose(pose, result);
  return result;
}

/// The head's left, up and forward at a pose: rolled, then nodded, then turned.
glm::mat3 head_axes(const Pose& pose) {
  const auto radians = [&pose](Control control) {
    return static_cast<float>(glm::radians(value(pose, control)));
  };
  const float yaw = radians(Control::HeadYaw);
  const float pitch = radians(Control::HeadPitch);
  const float roll = radians(Control::HeadRoll);
  const glm::mat3 turned{
      std::cos(yaw), 0.0F, -std::sin(yaw), 0.0F, 1.0F, 0.0F, std::sin(yaw), 0.0F, std::cos(yaw)};
  const glm::mat3 nodded{1.0F,
                         0.0F,
                         0.0F,
                         0.0F,
                         std::cos(pitch),
                         std::sin(pitch),
                         0.0F,
                         -std::sin(pitch),
                         std::cos(pitch)};
  const glm::mat3 rolled{std::cos(roll),
                         std::sin(roll),
                         0.0F,
                         -std::sin(roll),
                         std::cos(roll),
                         0.0F,
                         0.0F,
                         0.0F,
                         1.0F};
  return turned * nodded * rolled;
}

}  // namespace

struct HeadRenderer::Scene {
  Scene(const Head& drawn_head, const View& view, const Appearance& appearance)
      : head{drawn_head},
        current{posed(drawn_head, neutral_pose())},
        renderer{drawn_head.surfaces(), current, view, appearance} {}

  const Head& head;
  PosedHead current;
  SurfaceRenderer renderer;
};

HeadRenderer::HeadRenderer(const Head& head, const View& view, const Appearance& appearance)
    : scene_{std::make_unique<Scene>(head, view, appearance)} {}

HeadRenderer::~HeadRenderer() = default;

void HeadRenderer::draw(const Pose& pose, Image& image) {
  scene_->head.pose(pose, scene_->current);
  scene_->renderer.draw(scene_->current, head_axes(pose), image);
}

std::string HeadRenderer::description() const {
  return scene_->renderer.description();
}

}  // namespace bimodal::synth
