#pragma once

#include <string>
#include <string_view>

#include "stimuli/base/quantity.hpp"
#include "stimuli/labels/label_lines.hpp"

namespace bimodal {

/// The latest time in a label file, 11 days: so far a double resolves nanoseconds.
inline constexpr Duration kLatestTime = std::chrono::seconds{1'000'000};

/// By how much boundaries that should be the same may differ, because somebody rounded them.
inline constexpr Duration kRounding = std::chrono::microseconds{1};

/// A time in seconds, written as a decimal number with a point ("0.25", "1e-3") whatever the
/// locale, to the nearest nanosecond. Throws Error naming the line if it is no number, negative by
/// more than kRounding, or beyond kLatestTime.
[[nodiscard]] Duration time_from_seconds(std::string_view text, const LabelLine& line);

/// The same for a whole number of units of time; `unit_name` is for messages, e.g. "100 ns".
[[nodiscard]] Duration time_from_units(std::string_view text,
                                       Duration unit,
                                       std::string_view unit_name,
                                       const LabelLine& line);

/// A time >= 0 in seconds, exactly: up to nine decimals, at least one: "0.0", "1.25".
[[nodiscard]] std::string seconds_text(Duration time);

/// A time >= 0 to the nearest unit, ties up: times in order stay in order.
[[nodiscard]] std::string units_text(Duration time, Duration unit);

}  // namespace bimodal
