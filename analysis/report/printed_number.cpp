#include "analysis/report/printed_number.hpp"

#include <cmath>

#include <fmt/format.h>

namespace bimodal::analysis {

std::string print_decimals(double value, int decimals) {
  auto text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  if (text.starts_with("0.")) text.erase(0, 1);
  return (value < 0.0 && !zero ? "-" : "") + text;
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
