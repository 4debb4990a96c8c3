#include "synth/face/lip_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "synth/face/smoothing.hpp"

namespace bimodal::synth {

namespace {

// By ring, 0 to 9.
using PerRing = std::array<double, MouthLoops::kLastRing + 1>;
constexpr PerRing kFollowing{0.0, 0.10, 0.30, 0.52, 0.70, 0.90, 1.0, 1.0, 1.0, 0.35};
constexpr PerRing kPressedToLine{0.0, 0.0, 0.12, 0.32, 0.42, 0.36, 0.0, 0.0, 0.0, 0.0};
constexpr PerRing kPressedInward{0.0, 0.0, 0.0, 0.1, 1.3, 2.4, 1.0, 0.5, 0.0, 0.0};  // mm

// How soon narrowing closes a pair, from the midline (column 0) to beside the corner (7).
constexpr std::array<double, MouthLoops::kCorner> kZip{0.0, 0.04, 0.20, 0.74, 0.96, 1.0, 1.0, 1.0};
constexpr double kFullZipMm = 16.0;
// Spread lips meet beside the corners, so that the opening ends in a point there.
constexpr std::array<double, MouthLoops::kCorner> kSpreadZip{
    0.0, 0.0, 0.0, 0.0, 0.0, 0.10, 0.32, 0.62};
constexpr double kFullSpreadMm = 8.0;

constexpr double kUpperShare = 0.30;    // of the way to contact
constexpr double kJoinMm = 1.5;         // over this last gap the contact rings are drawn together
constexpr double kJoinAtContact = 0.6;  // and the lips beside them approach in depth by this part

/// A ring's facing points.
struct Facing {
  glm::dvec3* upper;
  glm::dvec3* lower;
};

/// The facing points of one column, ring by ring.
class FacingColumn {
 public:
  FacingColumn(const MouthLoops& mouth,
               int column,
               MouthLoops::Side side,
               std::span<glm::dvec3> skin) {
    for (int ring = MouthLoops::kFirstRing; ring <= MouthLoops::kLastRing; ++ring) {
      rings_.at(static_cast<std::size_t>(ring)) = {
          &skin[mouth.vertex(ring, column, side)],
          &skin[mouth.vertex(ring, 2 * MouthLoops::kCorner - column, side)]};
    }
  }

  [[nodiscard]] const Facing& ring(std::size_t ring) const { return rings_.at(ring); }

  [[nodiscard]] double gap() const { return ring(6).upper->y - ring(6).lower->y; }

  /// Moves both lips by the shares of `way` (mm down for the upper), and in z towards each other.
  void close(double way, double join_z) const {
    for (std::size_t j = 1; j < rings_.size(); ++j) {
      const auto [upper, lower] = rings_[j];
      upper->y -= kUpperShare * way * kFollowing[j];
      lower->y += (1.0 - kUpperShare) * way * kFollowing[j];
      if (j >= 5 && j <= 8) {
        upper->z += 0.5 * join_z * kFollowing[j];
        lower->z -= 0.5 * join_z * kFollowing[j];
      }
    }
  }

  void press(double compression, double lateral) const {
    const double line = 0.5 * (ring(6).upper->y + ring(6).lower->y);
    for (std::size_t j = 1; j < rings_.size(); ++j) {
      for (auto* const point : {rings_[j].upper, rings_[j].lower}) {
        point->y += (line - point->y) * kPressedToLine[j] * compression;
        point->z -= kPressedInward[j] * compression * (1.0 - 0.5 * lateral);
      }
    }
  }

  /// Draws the contact rings together in x and z, and their gaps to that of the first of them; at
  /// `near` 1 they coincide.
  void seal(double near) const {
    if (near <= 0.0) return;
    const double first_gap = gap();
    for (std::size_t j = 6; j <= 8; ++j) {
      const auto [upper, lower] = rings_[j];
      const auto middle = 0.5 * (*upper + *lower);
      const double open = upper->y - lower->y;
      const double wanted = near < 1.0 ? std::max(0.0, open + near * (first_gap - open)) : 0.0;
      *upper += near * (middle - *upper);
      *lower += near * (middle - *lower);
      upper->y = middle.y + 0.5 * wanted;
      lower->y = middle.y - 0.5 * wanted;
      if (near >= 1.0) *upper = *lower = middle;
    }
  }

 private:
  std::array<Facing, MouthLoops::kLastRing + 1> rings_{};
};

void bring_together(const LipContact& contact, int column, const FacingColumn& lips) {
  const double narrowing = std::clamp(-contact.width_mm / kFullZipMm, 0.0, 1.0);
  const double spreading = std::clamp(contact.width_mm / kFullSpreadMm, 0.0, 1.0);
  const auto place = static_cast<std::size_t>(column);
  const double closure =
      std::max({contact.closure, narrowing * kZip.at(place), spreading * kSpreadZip.at(place)});
  const double gap = lips.gap();
  const double remaining = std::max(0.0, gap * (1.0 - closure));
  // Everything below varies continuously with gap and closure, so that lips part without a jump.
  const double near = 1.0 - smooth_step(0.0, kJoinMm, remaining);
  const double depth = lips.ring(6).lower->z - lips.ring(6).upper->z;
  lips.close(gap - remaining, depth * std::max(closure, kJoinAtContact * near));
  if (contact.compression > 0.0) {
    lips.press(contact.compression, static_cast<double>(column) / MouthLoops::kCorner);
  }
  lips.seal(near);
}

}  // namespace

void bring_lips_together(const LipContact& contact,
                         const MouthLoops& mouth,
                         std::span<glm::dvec3> skin) {
  using enum MouthLoops::Side;
  for (int column = 0; column < MouthLoops::kCorner; ++column) {
    bring_together(contact, column, {mouth, column, Left, skin});
    if (column > 0) bring_together(contact, column, {mouth, column, Right, skin});
  }
}

}  // namespace bimodal::synth
