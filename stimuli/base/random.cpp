#include "stimuli/base/random.hpp"

#include <bit>
#include <cassert>
#include <cmath>
#include <numeric>

namespace bimodal {

namespace {

/// One step of SplitMix64 (Steele, Lea & Flood 2014).
std::uint64_t split_mix(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15U;
  std::uint64_t z = state;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

}  // namespace

Seed derive_seed(Seed parent,
                 std::string_view purpose,
                 std::initializer_list<std::uint64_t> indices) {
  std::uint64_t state = parent;
  Seed seed = split_mix(state);
  const auto absorb = [&](std::uint64_t value) {
    state ^= value;
    seed = std::rotl(seed, 23) ^ split_mix(state);
  };
  for (const char letter : purpose) absorb(static_cast<unsigned char>(letter));
  absorb(purpose.size());
  for (const auto index : indices) absorb(index);
  return seed;
}

Random::Random(Seed seed) : state_{} {
  for (auto& word : state_) word = split_mix(seed);
}

double Random::uniform() {
  return static_cast<double>(bits() >> 11U) * 0x1p-53;
}

std::uint64_t Random::below(std::uint64_t bound) {
  assert(bound > 0);
  const std::uint64_t unbiased_from = (0 - bound) % bound;  // 2^64 mod bound
  while (true) {
    const std::uint64_t drawn = bits();
    if (drawn >= unbiased_from) return drawn % bound;
  }
}

double Random::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  while (true) {
    const double u = 2.0 * uniform() - 1.0;
    const double v = 2.0 * uniform() - 1.0;
    const double s = u * u + v * v;
    if (s >= 1.0 || s == 0.0) continue;
    const double scale = std::sqrt(-2.0 * std::log(s) / s);
    spare_ = v * scale;
    has_spare_ = true;
    return u * scale;
  }
}

std::size_t Random::weighted(std::span<const double> weights) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  assert(total > 0.0);
  double remaining = uniform() * total;
  std::size_t last_possible = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] <= 0.0) continue;
    last_possible = i;
    if (remaining < weights[i]) return i;
    remaining -= weights[i];
  }
  return last_possible;  // reached only by rounding
}

}  // namespace bimodal
