#include "synth/inspection/outside_cells.hpp"

#include <cmath>

namespace bimodal::synth {

namespace {

constexpr float kCell = 1.0F;             // mm
constexpr float kHalfDiagonal = 0.8661F;  // of a cell; a little more

std::size_t cells(float length) {
  return static_cast<std::size_t>(std::ceil(length / kCell)) + 2;
}

}  // namespace

OutsideCells::OutsideCells(const SurfaceTree& surface,
                           const glm::vec3& least,
                           const glm::vec3& most)
    : least_{least - kCell},
      size_{cells(most.x - least.x), cells(most.y - least.y), cells(most.z - least.z)},
      outside_(size_[0] * size_[1] * size_[2]) {
  spread_from_the_border(empty_cells(surface));
}

std::vector<bool> OutsideCells::empty_cells(const SurfaceTree& surface) const {
  std::vector<bool> empty;
  empty.reserve(outside_.size());
  const auto middle = [](std::size_t cell) { return (static_cast<float>(cell) + 0.5F) * kCell; };
  for (std::size_t z = 0; z < size_[2]; ++z) {
    for (std::size_t y = 0; y < size_[1]; ++y) {
      for (std::size_t x = 0; x < size_[0]; ++x) {
        const auto point = least_ + glm::vec3{middle(x), middle(y), middle(z)};
        const float distance = surface.signed_distance(point, 2.0F * kHalfDiagonal);
        empty.push_back(std::abs(distance) > kHalfDiagonal);
      }
    }
  }
  return empty;
}

void OutsideCells::spread_from_the_border(const std::vector<bool>& empty) {
  std::vector<Cell> reached;
  const auto reach = [&](const Cell& cell) {
    const auto place = index(cell);
    if (!empty[place] || outside_[place]) return;
    outside_[place] = true;
    reached.push_back(cell);
  };
  reach({0, 0, 0});  // the border's cells hang together
  while (!reached.empty()) {
    const Cell cell = reached.back();
    reached.pop_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Cell neighbour = cell;
      if (cell.at(axis) > 0) {
        neighbour.at(axis) = cell.at(axis) - 1;
        reach(neighbour);
      }
      if (cell.at(axis) + 1 < size_.at(axis)) {
        neighbour.at(axis) = cell.at(axis) + 1;
        reach(neighbour);
      }
    }
  }
}

bool OutsideCells::surely_hold(const glm::vec3& point) const {
  const glm::vec3 place = (point - least_) / kCell;
  Cell cell{};
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (place[axis] < 0.0F || place[axis] >= static_cast<float>(size_.at(i))) return true;
    cell.at(i) = static_cast<std::size_t>(place[axis]);
  }
  return outside_[index(cell)];
}

}  // namespace bimodal::synth
