#include "synth/face/palate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "synth/face/quad_normals.hpp"
#include "synth/face/smoothing.hpp"

namespace bimodal::synth {

namespace {

// The midline from back to front: soft palate, vault, alveolar ridge, necks of the incisors.
constexpr std::array<double, 7> kMidlineZ{30.0, 45.0, 54.0, 62.0, 79.0, 87.0, 89.5};
constexpr std::array<double, 7> kMidlineY{-70.0, -61.5, -60.2, -60.0, -63.5, -68.2, kPalateLowest};

constexpr std::array<double, 7> kWidthZ{30.0, 50.0, 62.0, 72.0, 80.0, 86.0, 89.5};
constexpr std::array<double, 7> kHalfWidth{18.0, 18.0, 17.0, 15.5, 13.5, 10.0, 7.0};

constexpr double kGumLine = -69.5;  // where the sheet meets the gum at the sides
constexpr double kSteepness = 2.6;  // exponent of the vault's section; 2 would be a parabola

constexpr std::size_t kAlong = 36;
constexpr std::size_t kAcross = 33;

}  // namespace

double palate_half_width(double z) {
  return interpolate(z, kWidthZ, kHalfWidth);
}

double palate_y(double x, double z) {
  const double midline = interpolate(z, kMidlineZ, kMidlineY);
  const double part = std::min(1.0, std::abs(x) / palate_half_width(z));
  return midline - (midline - std::min(midline, kGumLine)) * std::pow(part, kSteepness);
}

RigidPart palate_part() {
  std::vector<glm::vec3> positions;
  std::vector<Stencils::Quad> quads;
  for (std::size_t i = 0; i < kAlong; ++i) {
    const double z = kPalateBack + (kPalateFront - kPalateBack) * static_cast<double>(i) /
                                       static_cast<double>(kAlong - 1);
    for (std::size_t j = 0; j < kAcross; ++j) {
      const double side = 2.0 * static_cast<double>(j) / static_cast<double>(kAcross - 1) - 1.0;
      const double x = side * palate_half_width(z);
      positions.emplace_back(x, palate_y(x, z), z);
    }
  }
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i + 1 < kAlong; ++i) {
    for (std::size_t j = 0; j + 1 < kAcross; ++j) {
      const auto corner = [&](std::size_t row, std::size_t column) {
        return static_cast<std::uint32_t>(row * kAcross + column);
      };
      const auto a = corner(i, j);
      const auto b = corner(i, j + 1);
      const auto c = corner(i + 1, j + 1);
      const auto d = corner(i + 1, j);
      quads.push_back({a, b, c, d});
      triangles.insert(triangles.end(), {a, b, c, a, c, d});
    }
  }
  RigidPart part{.carrier = RigidPart::Carrier::UpperTeeth,
                 .description = unmasked(Material::Gum, std::move(triangles), positions),
                 .at_rest = {}};
  part.description.name = "palate";
  quad_normals(positions, quads, part.at_rest.normals);
  part.at_rest.positions = std::move(positions);
  return part;
}

}  // namespace bimodal::synth
