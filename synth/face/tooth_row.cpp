#include "synth/face/tooth_row.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace bimodal::synth {

namespace {

constexpr double kFirstZ = 30.0;
constexpr double kNothing = std::numeric_limits<double>::infinity();

/// The teeth seen along y: in each cell how far they come towards the other jaw, or kNothing.
class EdgeMap {
 public:
  EdgeMap(std::size_t columns, std::size_t rows, double cell, bool upper)
      : columns_{columns},
        rows_{rows},
        cell_{cell},
        upper_{upper},
        edges(columns * rows, kNothing) {}

  void draw(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    // Finely enough that no cell is missed.
    const double longest =
        std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    const int steps = 1 + static_cast<int>(std::ceil(2.0 * longest / cell_));
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        const double u = static_cast<double>(i) / steps;
        const double v = static_cast<double>(j) / steps;
        mark(a + u * (b - a) + v * (c - a));
      }
    }
  }

 private:
  void mark(const glm::dvec3& point) {
    const double column = std::floor(point.x / cell_);
    const double row = std::floor((point.z - kFirstZ) / cell_);
    if (column < 0 || row < 0 || column >= static_cast<double>(columns_) ||
        row >= static_cast<double>(rows_)) {
      return;
    }
    double& edge =
        edges[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)];
    if (edge == kNothing || (upper_ ? point.y < edge : point.y > edge)) edge = point.y;
  }

  std::size_t columns_;
  std::size_t rows_;
  double cell_;
  bool upper_;

 public:
  std::vector<double> edges;
};

}  // namespace

ToothRow::ToothRow(std::span<const glm::vec3> positions,
                   std::span<const std::uint32_t> triangles,
                   Jaw jaw)
    : jaw_{jaw}, cells_(kColumns * kRows) {
  EdgeMap map{kColumns, kRows, kCell, jaw == Jaw::Upper};
  for (std::size_t t = 0; t + 3 <= triangles.size(); t += 3) {
    map.draw(glm::dvec3{positions[triangles[t]]},
             glm::dvec3{positions[triangles[t + 1]]},
             glm::dvec3{positions[triangles[t + 2]]});
  }
  fill(map.edges);
  smooth();
}

/// The edges, and beside the teeth that of the nearest tooth.
std::vector<double> ToothRow::spread(std::span<const double> edges) {
  std::vector<double> result(edges.begin(), edges.end());
  std::vector<std::size_t> border;
  for (std::size_t place = 0; place < result.size(); ++place) {
    if (result[place] != kNothing) border.push_back(place);
  }
  for (std::size_t next = 0; next < border.size(); ++next) {
    const std::size_t place = border[next];
    const std::size_t column = place % kColumns;
    const std::size_t row = place / kColumns;
    const auto reach = [&](std::size_t neighbour) {
      if (result[neighbour] != kNothing) return;
      result[neighbour] = result[place];
      border.push_back(neighbour);
    };
    if (column > 0) reach(place - 1);
    if (column + 1 < kColumns) reach(place + 1);
    if (row > 0) reach(place - kColumns);
    if (row + 1 < kRows) reach(place + kColumns);
  }
  return result;
}

/// Where there is room: what can be reached from the back of the mouth, row by row, before a tooth
/// is met; elsewhere the way back to it.
void ToothRow::fill(std::span<const double> edges) {
  const auto middle = [](std::size_t column, std::size_t row) {
    return glm::dvec2{static_cast<double>(column), static_cast<double>(row)};
  };
  std::vector<glm::dvec2> lingual;
  std::vector<bool> free(edges.size(), false);
  for (std::size_t row = 0; row < kRows; ++row) {
    for (std::size_t column = 0; column < kColumns; ++column) {
      const std::size_t place = row * kColumns + column;
      const bool tooth = edges[place] != kNothing;
      const bool behind_is_free = row == 0 || free[place - kColumns];
      const bool inside_is_free =
          column == 0 ? edges[place + 1] == kNothing : static_cast<bool>(free[place - 1]);
      free[place] = !tooth && behind_is_free && inside_is_free;
      if (tooth && (behind_is_free || (column > 0 && inside_is_free))) {
        lingual.push_back(middle(column, row));
      }
    }
  }
  const auto to_lingual = [&](const glm::dvec2& here) {
    double nearest = kNothing;
    for (const auto& at : lingual) nearest = std::min(nearest, glm::distance(at, here));
    return nearest * kCell;
  };
  const auto spread_edges = spread(edges);
  for (std::size_t row = 0; row < kRows; ++row) {
    for (std::size_t column = 0; column < kColumns; ++column) {
      const std::size_t place = row * kColumns + column;
      const auto here = middle(column, row);
      const double away = to_lingual(here);
      cells_[place].beyond = free[place] ? 0.5 * kCell - away : 0.5 * kCell + away;
      cells_[place].edge_y = spread_edges[place];
    }
  }
}

/// Rounds the nooks between teeth and the steps of the grid.
void ToothRow::smooth() {
  constexpr int kTimes = 2;
  for (int time = 0; time < kTimes; ++time) {
    const auto before = cells_;
    for (std::size_t row = 1; row + 1 < kRows; ++row) {
      for (std::size_t column = 0; column + 1 < kColumns; ++column) {
        const std::size_t inner = column == 0 ? 1 : column - 1;  // the other side is alike
        const auto at = [&](std::size_t c, std::size_t r) {
          return before[r * kColumns + c].beyond;
        };
        cells_[row * kColumns + column].beyond =
            0.25 * at(column, row) +
            0.125 *
                (at(inner, row) + at(column + 1, row) + at(column, row - 1) + at(column, row + 1)) +
            0.0625 * (at(inner, row - 1) + at(inner, row + 1) + at(column + 1, row - 1) +
                      at(column + 1, row + 1));
      }
    }
  }
}

ToothRow::Neighbourhood ToothRow::round(double x, double z) const {
  const double across =
      std::clamp(std::abs(x) / kCell - 0.5, 0.0, static_cast<double>(kColumns) - 1.001);
  const double along =
      std::clamp((z - kFirstZ) / kCell - 0.5, 0.0, static_cast<double>(kRows) - 1.001);
  const auto column = static_cast<std::size_t>(across);
  const auto row = static_cast<std::size_t>(along);
  return {.a = cell(column, row),
          .b = cell(column + 1, row),
          .c = cell(column, row + 1),
          .d = cell(column + 1, row + 1),
          .u = across - static_cast<double>(column),
          .v = along - static_cast<double>(row)};
}

double ToothRow::Neighbourhood::mixed(double Cell::*member) const {
  return (1 - v) * ((1 - u) * a.*member + u * b.*member) +
         v * ((1 - u) * c.*member + u * d.*member);
}

ToothRow::Place ToothRow::at(double x, double z) const {
  const auto near = round(x, z);
  const auto& [a, b, c, d, u, v] = near;
  const glm::dvec2 outward{(1 - v) * (b.beyond - a.beyond) + v * (d.beyond - c.beyond),
                           (1 - u) * (c.beyond - a.beyond) + u * (d.beyond - b.beyond)};
  const double steepness = glm::length(outward);
  Place place{.beyond = near.mixed(&Cell::beyond),
              .inward = {0.0, -1.0},
              .edge_y = near.mixed(&Cell::edge_y)};
  if (steepness > 1e-6) place.inward = -outward / steepness;
  if (x < 0) place.inward.x = -place.inward.x;
  return place;
}

}  // namespace bimodal::synth
