#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "stimuli/base/quantity.hpp"

namespace bimodal {

/// Pictures a second as a fraction in lowest terms, so that the time of every frame is exact: film
/// transferred to American television has 24000 in 1001 seconds.
struct FrameRate {
  std::int64_t pictures = 60;
  std::int64_t seconds = 1;

  bool operator==(const FrameRate&) const = default;

  [[nodiscard]] Hertz hertz() const {
    return Hertz{static_cast<double>(pictures) / static_cast<double>(seconds)};
  }

  /// When frame `number` is shown, from 0.
  [[nodiscard]] Milliseconds time_of(std::int64_t number) const {
    return Milliseconds{static_cast<double>(number * seconds * 1000) /
                        static_cast<double>(pictures)};
  }

  /// How many frames begin before `end`.
  [[nodiscard]] std::int64_t frames_before(Milliseconds end) const;
};

inline constexpr Hertz kLowestFrameRate{1};
inline constexpr Hertz kHighestFrameRate{1000};

/// The fraction in lowest terms. Precondition: both are above 0.
[[nodiscard]] FrameRate frame_rate_of(std::int64_t pictures, std::int64_t seconds);

/// The rate that is meant by a decimal number: 29.97 (and 23.976 or 23.98, 59.94, 119.88) is
/// 30000/1001, as all programs for video have it; any other is taken to six decimals. Precondition:
/// from kLowestFrameRate to kHighestFrameRate.
[[nodiscard]] FrameRate frame_rate_near(Hertz rate);

/// "60", "29.97" (see frame_rate_near) or "30000/1001"; absent if it is no rate from
/// kLowestFrameRate to kHighestFrameRate, or a fraction of numbers beyond a million.
[[nodiscard]] std::optional<FrameRate> parse_frame_rate(std::string_view text);

/// "60", "29.97 (30000/1001)".
[[nodiscard]] std::string describe(const FrameRate& rate);

}  // namespace bimodal
