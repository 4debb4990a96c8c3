#include "synth/face/mouth_loops.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::synth {

namespace {

constexpr std::size_t kAbsent = std::numeric_limits<std::size_t>::max();

std::size_t index(int number) {
  return static_cast<std::size_t>(number);
}

}  // namespace

MouthLoops::MouthLoops(std::span<const int> ring,
                       std::span<const int> column,
                       std::span<const double> x) {
  for (auto& side : vertex_) {
    for (auto& loop : side) loop.fill(kAbsent);
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] < kFirstRing || ring[i] > kLastRing) continue;
    if (column[i] < 0 || column[i] >= kColumns) {
      throw Error{fmt::format("the head's mouth has no column {} (vertex {})", column[i], i)};
    }
    const bool midline = column[i] == 0 || column[i] == kColumns - 1;
    if (midline || x[i] > 0.0) vertex_[0][index(ring[i])][index(column[i])] = i;
    if (midline || x[i] < 0.0) vertex_[1][index(ring[i])][index(column[i])] = i;
  }
  for (int r = kFirstRing; r <= kLastRing; ++r) {
    for (int k = 0; k < kColumns; ++k) {
      if (vertex(r, k, Side::Left) == kAbsent || vertex(r, k, Side::Right) == kAbsent) {
        throw Error{fmt::format(
            "the head's mouth lacks ring {}, column {}; regenerate it with tools/head", r, k)};
      }
    }
  }
}

std::size_t MouthLoops::vertex(int ring, int column, Side side) const {
  return vertex_[side == Side::Left ? 0 : 1][index(ring)][index(column)];
}

}  // namespace bimodal::synth
