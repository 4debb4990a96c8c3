#include "synth/face/lashes.hpp"

#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"
#include "synth/face/eyeball.hpp"
#include "synth/face/rigid_part.hpp"

namespace bimodal::synth {

/// The random part of a lash.
class LashScatter {
 public:
  float length() { return 0.75F + 0.35F * static_cast<float>(random_.uniform()); }

  glm::vec3 lean() {
    const auto x = random_.normal();
    const auto y = random_.normal();
    const auto z = random_.normal();
    return 0.06F * glm::vec3{x, y, z};
  }

 private:
  static constexpr Seed kSeed = 3;
  Random random_{kSeed};
};

namespace {

constexpr int kMarginRing = 4;
constexpr std::size_t kBladeVertices = 5;

struct Row {
  int count;
  double first;  ///< places round the margin: 0 inner corner, 5 middle above, 10 outer corner
  double last;
  float length_mm;
};

constexpr Row kUpperRow{.count = 58, .first = 0.9, .last = 9.6, .length_mm = 6.2F};
constexpr Row kLowerRow{.count = 34, .first = 11.0, .last = 18.0, .length_mm = 3.2F};

std::array<float, 4> catmull_rom(float t) {
  const float t2 = t * t;
  const float t3 = t2 * t;
  return {0.5F * (-t3 + 2.0F * t2 - t),
          0.5F * (3.0F * t3 - 5.0F * t2 + 2.0F),
          0.5F * (-3.0F * t3 + 4.0F * t2 + t),
          0.5F * (t3 - t2)};
}

std::array<float, 4> catmull_rom_slope(float t) {
  const float t2 = t * t;
  return {0.5F * (-3.0F * t2 + 4.0F * t - 1.0F),
          0.5F * (9.0F * t2 - 10.0F * t),
          0.5F * (-9.0F * t2 + 8.0F * t + 1.0F),
          0.5F * (3.0F * t2 - 2.0F * t)};
}

glm::vec3 weighted(std::span<const glm::vec3> skin,
                   const std::array<std::uint32_t, 4>& vertices,
                   const std::array<float, 4>& weights) {
  glm::vec3 sum{0.0F};
  for (std::size_t i = 0; i < vertices.size(); ++i) sum += weights[i] * skin[vertices[i]];
  return sum;
}

}  // namespace

Lashes::Lashes(const FieldTable& table, std::span<const glm::dvec3> rest) {
  const auto ring = table.whole_numbers("eye_ring");
  const auto column = table.whole_numbers("eye_column");
  LashScatter scatter;
  for (const bool left : {true, false}) {
    // The cage counts its columns from two before the inner corner.
    std::vector<std::uint32_t> margin;
    for (std::size_t place = 0; place < kMargin; ++place) {
      for (std::size_t i = 0; i < rest.size(); ++i) {
        const bool here = ring[i] == kMarginRing && (rest[i].x > 0.0) == left &&
                          static_cast<std::size_t>(column[i] + 2) % kMargin == place;
        if (here) margin.push_back(static_cast<std::uint32_t>(i));
      }
    }
    if (margin.size() != kMargin) {
      throw Error{
          fmt::format("the head's lid margin has {} vertices, not {}; regenerate the head "
                      "with tools/head",
                      margin.size(),
                      kMargin)};
    }
    grow(margin, left, true, scatter);
    grow(margin, left, false, scatter);
  }
}

void Lashes::grow(std::span<const std::uint32_t> margin,
                  bool left,
                  bool upper,
                  LashScatter& scatter) {
  const auto& row = upper ? kUpperRow : kLowerRow;
  const float side = left ? 1.0F : -1.0F;
  for (int i = 0; i < row.count; ++i) {
    const double place = row.first + (row.last - row.first) * i / (row.count - 1);
    const auto at = static_cast<std::size_t>(place);
    const auto between = static_cast<float>(place - std::floor(place));
    const auto lateral = static_cast<float>(((upper ? place : 20.0 - place) - 5.0) / 5.0);
    Lash lash{.margin = {},
              .place = catmull_rom(between),
              .along = catmull_rom_slope(between),
              .eye = {side * static_cast<float>(kLeftEyeCentre.x),
                      static_cast<float>(kLeftEyeCentre.y),
                      static_cast<float>(kLeftEyeCentre.z)},
              .lean = {},
              .length = 0.0F,
              .upper = upper};
    for (std::size_t j = 0; j < lash.margin.size(); ++j) {
      lash.margin.at(j) = margin[(at + kMargin - 1 + j) % kMargin];
    }
    lash.length = row.length_mm * scatter.length() * (1.0F - 0.35F * lateral * lateral) *
                  (1.0F + 0.25F * lateral);
    lash.lean = glm::vec3{side * 0.75F * lateral, 0.0F, 0.0F} + scatter.lean();
    lashes_.push_back(lash);
  }
}

void Lashes::place(std::span<const glm::vec3> skin, SurfaceGeometry& lashes) const {
  lashes.positions.clear();
  constexpr glm::vec3 kForward{0.0F, 0.0F, 1.0F};
  for (const auto& lash : lashes_) {
    const auto root = weighted(skin, lash.margin, lash.place);
    const auto away = glm::normalize(root - lash.eye);
    const auto along = glm::normalize(weighted(skin, lash.margin, lash.along));
    const glm::vec3 up{0.0F, lash.upper ? 1.0F : -1.0F, 0.0F};
    const auto bend = root + 0.45F * lash.length *
                                 (0.85F * kForward + (lash.upper ? 0.05F : 0.45F) * up +
                                  0.5F * lash.lean + 0.3F * away);
    const auto tip = root + lash.length * (0.80F * kForward + (lash.upper ? 0.62F : 0.55F) * up +
                                           0.9F * lash.lean + 0.15F * away);
    const auto half = (lash.upper ? 0.17F : 0.10F) * along;
    lashes.positions.insert(
        lashes.positions.end(),
        {root - half, root + half, bend - 0.75F * half, bend + 0.75F * half, tip});
  }
  constexpr glm::vec3 kFacing{0.0F, 0.30151F, 0.95346F};  // all lashes are lit alike
  lashes.normals.assign(lashes.positions.size(), kFacing);
}

SurfaceDescription Lashes::description(std::span<const glm::vec3> rest_skin) const {
  SurfaceGeometry at_rest;
  place(rest_skin, at_rest);
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i < lashes_.size(); ++i) {
    const auto v = static_cast<std::uint32_t>(i * kBladeVertices);
    triangles.insert(triangles.end(), {v, v + 1, v + 3, v, v + 3, v + 2, v + 2, v + 3, v + 4});
  }
  return unmasked(Material::Lash, std::move(triangles), std::move(at_rest.positions));
}

}  // namespace bimodal::synth
