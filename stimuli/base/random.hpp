#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>

namespace bimodal {

/// The starting point of a random stream; stored with whatever was drawn from it.
using Seed = std::uint64_t;

/// An independent seed for one purpose, e.g. derive_seed(session_seed, "noise", {trial}). Equal
/// arguments give equal seeds on every machine; any difference gives an unrelated stream.
[[nodiscard]] Seed derive_seed(Seed parent,
                               std::string_view purpose,
                               std::initializer_list<std::uint64_t> indices = {});

/// Random numbers that are the same on every machine: xoshiro256** (Blackman & Vigna 2018), its
/// state filled by SplitMix64, and distributions of our own, because those of the standard library
/// differ between implementations.
class Random {
 public:
  explicit Random(Seed seed);

  /// 64 random bits.
  std::uint64_t bits();

  /// Uniform in [0, 1), 53 bits.
  double uniform();

  /// Uniform in {0, ..., bound - 1}; bound > 0. Unbiased (rejection).
  std::uint64_t below(std::uint64_t bound);

  /// Standard normal, by the polar method of Marsaglia.
  double normal();

  /// Index drawn with probability proportional to its weight; weights >= 0, at least one > 0.
  std::size_t weighted(std::span<const double> weights);

 private:
  std::array<std::uint64_t, 4> state_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

inline std::uint64_t Random::bits() {
  auto& s = state_;
  const std::uint64_t result = std::rotl(s[1] * 5, 7) * 9;
  const std::uint64_t shifted = s[1] << 17U;
  s[2] ^= s[0];
  s[3] ^= s[1];
  s[1] ^= s[2];
  s[0] ^= s[3];
  s[2] ^= shifted;
  s[3] = std::rotl(s[3], 45);
  return result;
}

/// Every order equally likely (Fisher & Yates).
template <typename T>
void shuffle(std::span<T> items, Random& random) {
  for (std::size_t last = items.size(); last > 1; --last) {
    std::swap(items[last - 1], items[random.below(last)]);
  }
}

}  // namespace bimodal
