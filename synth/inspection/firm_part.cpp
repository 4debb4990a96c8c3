#include "synth/inspection/firm_part.hpp"

#include <algorithm>
#include <numeric>

#include <glm/common.hpp>

namespace bimodal::synth {

namespace {

glm::vec3 least(std::span<const glm::vec3> positions) {
  return std::accumulate(
      positions.begin(), positions.end(), positions.front(), [](const auto& a, const auto& b) {
        return glm::min(a, b);
      });
}

glm::vec3 most(std::span<const glm::vec3> positions) {
  return std::accumulate(
      positions.begin(), positions.end(), positions.front(), [](const auto& a, const auto& b) {
        return glm::max(a, b);
      });
}

}  // namespace

FirmPart::FirmPart(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles)
    : tree_{positions, triangles}, outside_{tree_, least(positions), most(positions)} {}

float FirmPart::depth(const glm::vec3& point) const {
  if (outside_.surely_hold(point)) return 0.0F;
  return std::max(0.0F, -tree_.signed_distance(point, kDeepest));
}

}  // namespace bimodal::synth
