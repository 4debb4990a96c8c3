#pragma once

#include <optional>

namespace bimodal::analysis {

/// What a face adds to a voice, from proportions correct. Absent where it is not defined.
struct Benefit {
  double gain = 0.0;  ///< AV - A
  /// (AV - A) / (1 - A): of what could be gained (Sumby & Pollack, 1954, J. Acoust. Soc. Am. 26,
  /// 212-215); absent if A is 1.
  std::optional<double> relative;
  /// (AV - V) / (1 - V): what the voice adds to the face.
  std::optional<double> auditory_relative;
  /// logit AV - logit A; absent if either is 0 or 1.
  std::optional<double> log_odds;
  /// AV less A + V - A V: above what two independent chances to be right would give; absent
  /// without V.
  std::optional<double> excess;
};

[[nodiscard]] Benefit benefit(double bimodal, double auditory, std::optional<double> visual);

/// Of the natural face's benefit the part that the synthetic one gives: (AVs - A) / (AVn - A); with
/// A = 0 the ratio of two faces alone. Absent where the natural face gives none.
[[nodiscard]] std::optional<double> share_of_natural_benefit(double synthetic,
                                                             double natural,
                                                             double auditory);

}  // namespace bimodal::analysis
