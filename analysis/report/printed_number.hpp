#pragma once

#include <optional>
#include <string>

namespace bimodal::analysis {

/// Numbers for people, as APA 7 prints what cannot be above 1 (proportions, correlations, p): no
/// zero before the decimal point.

/// So many decimals, with the zero before the point: "0.43", "-1.07"; never "-0.00". A half is
/// rounded away from zero, also where the binary number is a hair below: 3/40 is "0.08".
[[nodiscard]] std::string print_rounded(double value, int decimals);

/// A share in percent with one decimal: "87.5" of .875.
[[nodiscard]] std::string print_percent(double share);

/// As print_rounded, without the zero: ".43", "-.07", "1.00"; never "-.00".
[[nodiscard]] std::string print_decimals(double value, int decimals = 2);

/// A hyphen where there is none.
[[nodiscard]] std::string print_decimals(const std::optional<double>& value, int decimals = 2);

/// A proportion: ".07", "1.00".
[[nodiscard]] std::string print_proportion(double proportion);

/// A number of responses: "86", or "86.5" where responses were shared out between cells.
[[nodiscard]] std::string print_count(double count);

/// "p = .023", "p < .001".
[[nodiscard]] std::string print_p(double p);

}  // namespace bimodal::analysis
