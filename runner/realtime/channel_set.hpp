#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace bimodal::runner {

/// Some of the channels of a sound output; of the first 32.
class ChannelSet {
 public:
  constexpr ChannelSet() = default;

  /// Adds a channel, counted from 0.
  constexpr void add(std::size_t channel) noexcept { bits_ |= std::uint32_t{1} << channel; }

  [[nodiscard]] constexpr bool has(std::size_t channel) const noexcept {
    return channel < kMost && ((bits_ >> channel) & 1U) != 0;
  }

  /// How many channels an output must have for all of these to be heard.
  [[nodiscard]] constexpr int channels_needed() const noexcept {
    return static_cast<int>(std::bit_width(bits_));
  }

  constexpr bool operator==(const ChannelSet&) const = default;

  static constexpr std::size_t kMost = 32;

 private:
  std::uint32_t bits_ = 0;  ///< bit 0: the first channel
};

/// The first two channels: both ears of headphones.
inline constexpr ChannelSet kBothEars = [] {
  ChannelSet ears;
  ears.add(0);
  ears.add(1);
  return ears;
}();

}  // namespace bimodal::runner
