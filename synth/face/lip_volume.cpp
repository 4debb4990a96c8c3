#include "synth/face/lip_volume.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace bimodal::synth {

namespace {

using Side = MouthLoops::Side;

constexpr double kMostMm = 1.8;
constexpr int kFirstRing = 3;  // of a section; the last is MouthLoops::kLastRing
constexpr int kBorder = 4;
constexpr int kFullest = 5;
constexpr int kContact = 6;

// What follows the fullest vermilion, and how far.
constexpr std::array<std::pair<int, double>, 3> kSwelling{{{3, 0.15}, {4, 0.5}, {5, 1.0}}};

/// The sections of one side of a posed mouth.
class Sections {
 public:
  Sections(const MouthLoops& mouth, Side side, std::span<const glm::dvec3> skin)
      : mouth_{mouth}, side_{side}, skin_{skin} {}

  /// Of the slice that reaches half way to both neighbours, mm3.
  [[nodiscard]] double volume(int column) const {
    glm::dvec3 area{0.0};
    auto before = at(MouthLoops::kLastRing, column);
    for (int ring = kFirstRing; ring <= MouthLoops::kLastRing; ++ring) {
      const auto point = at(ring, column);
      area += 0.5 * glm::cross(before, point);
      before = point;
    }
    return std::abs(glm::dot(area, along(column)));
  }

  /// By which the volume grows for each mm that the section swells, mm2.
  [[nodiscard]] double growth(int column) const {
    const auto direction = outward(column);
    glm::dvec3 area{0.0};
    for (const auto& [ring, share] : kSwelling) {
      const int before = ring == kFirstRing ? MouthLoops::kLastRing : ring - 1;
      area += 0.5 * share * glm::cross(direction, at(ring + 1, column) - at(before, column));
    }
    return std::abs(glm::dot(area, along(column)));
  }

  /// The lip's unit normal where it is fullest, across its length; level, so that what swells does
  /// not meet the other lip.
  [[nodiscard]] glm::dvec3 outward(int column) const {
    const auto chord = at(kContact, column) - at(kBorder, column);
    auto normal = glm::cross(chord, along(column));
    normal.y = 0.0;
    const auto bulge = at(kFullest, column) - 0.5 * (at(kContact, column) + at(kBorder, column));
    return glm::normalize(glm::dot(normal, bulge) < 0.0 ? -normal : normal);
  }

 private:
  [[nodiscard]] glm::dvec3 at(int ring, int column) const {
    return skin_[mouth_.vertex(ring, column, side_)];
  }

  /// From half way to the column before to half way to the next; across the midline from side to
  /// side.
  [[nodiscard]] glm::dvec3 along(int column) const {
    const auto beside = [&](int neighbour) {
      if (neighbour >= 0 && neighbour < MouthLoops::kColumns) return at(kFullest, neighbour);
      const Side other = side_ == Side::Left ? Side::Right : Side::Left;
      const int inner = neighbour < 0 ? 1 : MouthLoops::kColumns - 2;
      return skin_[mouth_.vertex(kFullest, inner, other)];
    };
    return 0.5 * (beside(column + 1) - beside(column - 1));
  }

  const MouthLoops& mouth_;
  Side side_;
  std::span<const glm::dvec3> skin_;
};

}  // namespace

LipVolume::LipVolume(const MouthLoops& mouth, std::span<const glm::dvec3> rest) {
  const Sections sections{mouth, Side::Left, rest};
  for (int column = 0; column < MouthLoops::kColumns; ++column) {
    rest_volume_.at(static_cast<std::size_t>(column)) = sections.volume(column);
  }
}

LipVolume::Swelling LipVolume::swelling(const MouthLoops& mouth,
                                        MouthLoops::Side side,
                                        std::span<const glm::dvec3> skin) const {
  const Sections sections{mouth, side, skin};
  std::array<double, MouthLoops::kColumns> wanted{};  // mm
  for (int column = 0; column < MouthLoops::kColumns; ++column) {
    if (column == MouthLoops::kCorner) continue;
    const auto i = static_cast<std::size_t>(column);
    const double lost = rest_volume_.at(i) - sections.volume(column);
    wanted.at(i) = std::clamp(lost / sections.growth(column), -kMostMm, kMostMm);
  }
  Swelling swelling{};
  for (int column = 0; column < MouthLoops::kColumns; ++column) {
    const auto i = static_cast<std::size_t>(column);
    const double before = wanted.at(column == 0 ? 1 : i - 1);
    const double after = wanted.at(column == MouthLoops::kColumns - 1 ? i - 1 : i + 1);
    const double smooth = 0.5 * wanted.at(i) + 0.25 * (before + after);
    swelling.at(i) = smooth * sections.outward(column);
  }
  return swelling;
}

void LipVolume::keep(const MouthLoops& mouth, std::span<glm::dvec3> skin) const {
  const Swelling left = swelling(mouth, Side::Left, skin);
  const Swelling right = swelling(mouth, Side::Right, skin);
  for (int column = 0; column < MouthLoops::kColumns; ++column) {
    const auto i = static_cast<std::size_t>(column);
    const bool on_midline = column == 0 || column == MouthLoops::kColumns - 1;
    for (const auto& [ring, share] : kSwelling) {
      skin[mouth.vertex(ring, column, Side::Left)] += share * left.at(i);
      if (!on_midline) skin[mouth.vertex(ring, column, Side::Right)] += share * right.at(i);
    }
  }
}

}  // namespace bimodal::synth
