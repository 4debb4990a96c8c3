#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace bimodal::synth {

/// A row of teeth as the tongue meets it, seen along y: how far each place (x, z) lies beyond the
/// teeth's lingual faces, and how far the teeth come down (or up) there. Made from the drawn teeth;
/// both sides are taken for alike.
class ToothRow {
 public:
  enum class Jaw : std::uint8_t { Upper, Lower };

  /// Triangles of the teeth at rest; those of the subject's left side (x > 0) count.
  ToothRow(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles, Jaw jaw);

  struct Place {
    double beyond = 0;    ///< mm beyond the lingual faces; negative where the tongue has room
    glm::dvec2 inward{};  ///< unit vector (x, z) to where there is room
    double edge_y = 0;    ///< mm: the teeth's end at this place, or of the nearest tooth
  };

  [[nodiscard]] Place at(double x, double z) const;

  /// The same as at().beyond, in less time.
  [[nodiscard]] double beyond(double x, double z) const { return round(x, z).mixed(&Cell::beyond); }

  /// mm by which a point at height y lies within the height of the teeth at `place`; negative:
  /// it passes them at the biting edge.
  [[nodiscard]] double depth(const Place& place, double y) const {
    return jaw_ == Jaw::Upper ? y - place.edge_y : place.edge_y - y;
  }

  /// +1: the way from the teeth's ends into the gap between the jaws is down; -1: up.
  [[nodiscard]] double into_gap() const { return jaw_ == Jaw::Upper ? -1.0 : 1.0; }

 private:
  static constexpr std::size_t kColumns = 74;  ///< across, from x = 0
  static constexpr std::size_t kRows = 150;    ///< along, from z = 30
  static constexpr double kCell = 0.5;         ///< mm

  struct Cell {
    double beyond = 0;
    double edge_y = 0;
  };

  /// Four cells round a place, and where it lies between them.
  struct Neighbourhood {
    const Cell& a;
    const Cell& b;  ///< beside a in x
    const Cell& c;  ///< beside a in z
    const Cell& d;
    double u;  ///< 0 at a and c, 1 at b and d
    double v;  ///< 0 at a and b, 1 at c and d

    [[nodiscard]] double mixed(double Cell::*member) const;
  };

  [[nodiscard]] Neighbourhood round(double x, double z) const;

  [[nodiscard]] const Cell& cell(std::size_t column, std::size_t row) const {
    return cells_[row * kColumns + column];
  }

  static std::vector<double> spread(std::span<const double> edges);
  void fill(std::span<const double> edges);
  void smooth();

  Jaw jaw_;
  std::vector<Cell> cells_;
};

}  // namespace bimodal::synth
