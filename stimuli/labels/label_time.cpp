#include "stimuli/labels/label_time.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace bimodal {

namespace {

constexpr double kNanosecondsPerSecond = 1e9;

/// Absent if it is no finite number; "+1" is one.
std::optional<double> number_of(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double number = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc{} && stop == text.data() + text.size();
  if (!whole || !std::isfinite(number)) return std::nullopt;
  return number;
}

/// A number of nanoseconds as a time, where a session can have it.
Duration within_limits(double nanoseconds, std::string_view text, const LabelLine& line) {
  if (nanoseconds < -static_cast<double>(kRounding.count())) {
    refuse(line,
           fmt::format("the time {} is negative", in_quotes(text)),
           "count times from the start of the recording");
  }
  if (nanoseconds > static_cast<double>(kLatestTime.count())) {
    refuse(line,
           fmt::format("the time {} is beyond {} s",
                       in_quotes(text),
                       std::chrono::duration_cast<std::chrono::seconds>(kLatestTime).count()),
           "is it in another unit?");
  }
  return Duration{std::max(0LL, std::llround(nanoseconds))};
}

}  // namespace

Duration time_from_seconds(std::string_view text, const LabelLine& line) {
  const auto seconds = number_of(text);
  if (!seconds) {
    refuse(line,
           fmt::format("{} is not a time", in_quotes(text)),
           "write seconds with a decimal point, e.g. 0.25");
  }
  return within_limits(*seconds * kNanosecondsPerSecond, text, line);
}

Duration time_from_units(std::string_view text,
                         Duration unit,
                         std::string_view unit_name,
                         const LabelLine& line) {
  const auto units = number_of(text);
  if (!units || *units != std::floor(*units)) {
    refuse(line,
           fmt::format("{} is not a time in units of {}", in_quotes(text), unit_name),
           "write a whole number");
  }
  return within_limits(*units * static_cast<double>(unit.count()), text, line);
}

std::string seconds_text(Duration time) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
  auto text = fmt::format("{}.{:09}", seconds.count(), (time - seconds).count());
  text.resize(std::max(text.find_last_not_of('0'), text.find('.') + 1) + 1);
  return text;
}

std::string units_text(Duration time, Duration unit) {
  return fmt::format("{}", (time + unit / 2) / unit);
}

}  // namespace bimodal
