#include "synth/face/lip_measures.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::synth {

namespace {

constexpr double kClosedMm = 0.001;  // below the rounding of single precision, about 1e-5 mm
constexpr double kVisibleMm = 0.6;   // a narrower slit does not count for the width
constexpr int kBorder = 4;           // ring of the vermilion border
constexpr int kFullest = 5;          // ring of the fullest vermilion
constexpr int kContact = 6;          // first ring where the lips touch
constexpr int kLastContact = 8;
constexpr int kUpper = 0;  // columns of the midline
constexpr int kLower = 16;
constexpr int kChinRow = 26;

/// The opening at one column, from the midline outward.
struct Slit {
  double x = 0.0;
  double gap = 0.0;
};

using Slits = std::array<Slit, MouthLoops::kCorner + 1>;

Slits slits_of(const MouthLoops& mouth, std::span<const glm::vec3> skin) {
  constexpr auto kSide = MouthLoops::Side::Left;  // both sides are alike
  Slits slits;
  for (int column = 0; column < MouthLoops::kCorner; ++column) {
    auto& slit = slits.at(static_cast<std::size_t>(column));
    const auto upper = [&](int ring) { return skin[mouth.vertex(ring, column, kSide)]; };
    const auto lower = [&](int ring) { return skin[mouth.vertex(ring, kLower - column, kSide)]; };
    slit.x = 0.5 * static_cast<double>(upper(kContact).x + lower(kContact).x);
    slit.gap = static_cast<double>(upper(kFullest).y - lower(kFullest).y);
    for (int ring = kContact; ring <= kLastContact; ++ring) {
      slit.gap = std::min(slit.gap, static_cast<double>(upper(ring).y - lower(ring).y));
    }
  }
  slits.back().x = static_cast<double>(skin[mouth.vertex(kContact, MouthLoops::kCorner, kSide)].x);
  return slits;
}

void shut_what_is_closed(Slits& slits) {
  for (auto& slit : slits) {
    if (slit.gap < kClosedMm) slit.gap = 0.0;
  }
}

double area_between(const Slits& slits) {
  double area = 0.0;
  for (std::size_t i = 1; i < slits.size(); ++i) {
    area += 0.5 * (slits[i].gap + slits[i - 1].gap) * (slits[i].x - slits[i - 1].x);
  }
  return 2.0 * area;
}

double visible_width(const Slits& slits) {
  for (std::size_t i = slits.size() - 1; i > 0; --i) {
    const auto& inner = slits[i - 1];
    const auto& outer = slits[i];
    if (inner.gap <= kVisibleMm) continue;
    const double part = (inner.gap - kVisibleMm) / (inner.gap - outer.gap);
    return 2.0 * (inner.x + part * (outer.x - inner.x));
  }
  return 0.0;
}

}  // namespace

LipRuler::LipRuler(const FieldTable& table,
                   const MouthLoops& mouth,
                   std::span<const glm::vec3> rest) {
  const auto row = table.whole_numbers("row");
  const auto column = table.whole_numbers("column");
  while (chin_ < row.size() && (row[chin_] != kChinRow || column[chin_] != 0)) ++chin_;
  if (chin_ == row.size()) {
    throw Error{fmt::format(
        "the head has no chin (row {}, column 0); regenerate it with tools/head", kChinRow)};
  }
  using enum MouthLoops::Side;
  rest_upper_z_ = rest[mouth.vertex(kFullest, kUpper, Left)].z;
  rest_lower_z_ = rest[mouth.vertex(kFullest, kLower, Left)].z;
  rest_chin_y_ = rest[chin_].y;
  rest_corner_ = corner(mouth, rest);
}

glm::vec3 LipRuler::corner(const MouthLoops& mouth, std::span<const glm::vec3> skin) {
  using enum MouthLoops::Side;
  const auto& left = skin[mouth.vertex(kBorder, MouthLoops::kCorner, Left)];
  const auto& right = skin[mouth.vertex(kBorder, MouthLoops::kCorner, Right)];
  return 0.5F * (left + glm::vec3{-right.x, right.y, right.z});
}

LipMeasures LipRuler::measure(const MouthLoops& mouth, std::span<const glm::vec3> skin) const {
  using enum MouthLoops::Side;
  const auto at = [&](int ring, int column, MouthLoops::Side side) {
    return skin[mouth.vertex(ring, column, side)];
  };
  auto slits = slits_of(mouth, skin);
  const double smallest_gap = std::ranges::min(slits, {}, &Slit::gap).gap;
  shut_what_is_closed(slits);
  const glm::vec3 corner_moved = corner(mouth, skin) - rest_corner_;
  return {
      .inner_height_mm = slits.front().gap,
      .inner_width_mm = visible_width(slits),
      .inner_area_mm2 = area_between(slits),
      .outer_width_mm = static_cast<double>(at(kBorder, MouthLoops::kCorner, Left).x -
                                            at(kBorder, MouthLoops::kCorner, Right).x),
      .outer_height_mm =
          static_cast<double>(at(kBorder, kUpper, Left).y - at(kBorder, kLower, Left).y),
      .upper_protrusion_mm = static_cast<double>(at(kFullest, kUpper, Left).z - rest_upper_z_),
      .lower_protrusion_mm = static_cast<double>(at(kFullest, kLower, Left).z - rest_lower_z_),
      .corner_out_mm = static_cast<double>(corner_moved.x),
      .corner_up_mm = static_cast<double>(corner_moved.y),
      .corner_forward_mm = static_cast<double>(corner_moved.z),
      .chin_drop_mm = static_cast<double>(rest_chin_y_ - skin[chin_].y),
      .largest_gap_mm = std::ranges::max(slits, {}, &Slit::gap).gap,
      .smallest_gap_mm = smallest_gap,
      .inner_centre = 0.5F * (at(kContact, kUpper, Left) + at(kContact, kLower, Left)),
  };
}

}  // namespace bimodal::synth
