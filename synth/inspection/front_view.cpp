#include "synth/inspection/front_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace bimodal::synth {

namespace {

// The stretch of the face that is looked at, mm.
constexpr float kLeastX = -42.0F;
constexpr float kLeastY = -118.0F;
constexpr float kLeastZ = 25.0F;  // nothing behind it is in the mouth
constexpr int kColumns = 420;
constexpr int kRows = 380;

constexpr std::uint8_t kNothing = 255;

float column_of(float x) {
  return (x - kLeastX) / FrontView::kCell;
}

float row_of(float y) {
  return (y - kLeastY) / FrontView::kCell;
}

/// Cells whose middles lie between two places along one axis.
struct Cells {
  int first;
  int last;
};

Cells between(float least, float most, int count) {
  return {std::max(0, static_cast<int>(std::ceil(least - 0.5F))),
          std::min(count - 1, static_cast<int>(std::floor(most - 0.5F)))};
}

}  // namespace

FrontView::FrontView()
    : nearest_(static_cast<std::size_t>(kColumns) * kRows),
      number_(static_cast<std::size_t>(kColumns) * kRows) {
  clear();
}

void FrontView::clear() {
  std::ranges::fill(nearest_, -std::numeric_limits<float>::infinity());
  std::ranges::fill(number_, kNothing);
}

void FrontView::draw(std::span<const glm::vec3> positions,
                     std::span<const std::uint32_t> triangles,
                     std::uint8_t number) {
  for (std::size_t t = 0; t + 3 <= triangles.size(); t += 3) {
    draw(positions[triangles[t]], positions[triangles[t + 1]], positions[triangles[t + 2]], number);
  }
}

void FrontView::draw(const glm::vec3& a,
                     const glm::vec3& b,
                     const glm::vec3& c,
                     std::uint8_t number) {
  if (std::max({a.z, b.z, c.z}) < kLeastZ) return;
  const auto columns =
      between(column_of(std::min({a.x, b.x, c.x})), column_of(std::max({a.x, b.x, c.x})), kColumns);
  const auto rows =
      between(row_of(std::min({a.y, b.y, c.y})), row_of(std::max({a.y, b.y, c.y})), kRows);
  const float doubled = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (doubled == 0.0F) return;
  for (int row = rows.first; row <= rows.last; ++row) {
    const float y = kLeastY + (static_cast<float>(row) + 0.5F) * kCell;
    for (int column = columns.first; column <= columns.last; ++column) {
      const float x = kLeastX + (static_cast<float>(column) + 0.5F) * kCell;
      const float of_b = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / doubled;
      const float of_c = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / doubled;
      if (of_b < 0.0F || of_c < 0.0F || of_b + of_c > 1.0F) continue;
      const float z = a.z + of_b * (b.z - a.z) + of_c * (c.z - a.z);
      const auto cell = static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column);
      if (z <= nearest_[cell]) continue;
      nearest_[cell] = z;
      number_[cell] = number;
    }
  }
}

double FrontView::area_of(std::uint8_t number) const {
  return area_of(number, -std::numeric_limits<double>::infinity());
}

double FrontView::area_of(std::uint8_t number, double z) const {
  std::size_t cells = 0;
  for (std::size_t i = 0; i < number_.size(); ++i) {
    if (number_[i] == number && static_cast<double>(nearest_[i]) > z) ++cells;
  }
  return static_cast<double>(cells) * static_cast<double>(kCell) * static_cast<double>(kCell);
}

}  // namespace bimodal::synth
