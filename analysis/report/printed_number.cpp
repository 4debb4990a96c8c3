#include "analysis/report/printed_number.hpp"

#include <cmath>

#include <fmt/format.h>

namespace bimodal::analysis {

namespace {

/// Rounding errors of a quotient or of a difference of quotients are far below this share of it,
/// and what is printed differs from its neighbours by far more.
constexpr double kHair = 1e-12;

}  // namespace

std::string print_rounded(double value, int decimals) {
  const auto text = fmt::format("{:.{}f}", std::abs(value) * (1.0 + kHair), decimals);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  return (value < 0.0 && !zero ? "-" : "") + text;
}

std::string print_percent(double share) {
  return print_rounded(100.0 * share, 1);
}

std::string print_decimals(double value, int decimals) {
  auto text = print_rounded(value, decimals);
  const std::size_t digits = text.starts_with('-') ? 1 : 0;
  if (text.compare(digits, 2, "0.") == 0) text.erase(digits, 1);
  return text;
}

std::string print_decimals(const std::optional<double>& value, int decimals) {
  return value ? print_decimals(*value, decimals) : "-";
}

std::string print_proportion(double proportion) {
  return print_decimals(proportion);
}

std::string print_count(double count) {
  const bool whole = std::abs(count - std::round(count)) < 1e-6;
  return fmt::format("{:.{}f}", count, whole ? 0 : 1);
}

std::string print_p(double p) {
  return p < 0.001 ? "p < .001" : "p = " + print_decimals(p, 3);
}

}  // namespace bimodal::analysis
