#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// What the stimuli and the responses of a matrix are in one respect; empty: it does not apply.
struct Feature {
  std::string name;
  std::vector<std::string> of_stimuli;
  std::vector<std::string> of_responses;
};

/// How much of a feature came through besides what is held, in bits per response that was analysed.
struct HeldInformation {
  std::string feature;
  double entropy = 0.0;            ///< H(feature | held), of the stimuli
  double transmitted = 0.0;        ///< T(feature | held)
  std::optional<double> relative;  ///< T / H; absent where the held features determine it
};

struct SinfaRound {
  double responses = 0.0;  ///< that agree with their stimulus in everything that is held
  std::vector<HeldInformation> candidates;  ///< every feature not held yet, in the order given
  /// Those with the largest T / H, which are held from now on. More than one: they tie, and are
  /// held together.
  std::vector<std::string> chosen;
};

struct Sinfa {
  double responses = 0.0;  ///< analysed
  double left_out = 0.0;   ///< for stimuli or responses to which some feature does not apply
  std::vector<SinfaRound> rounds;
  std::vector<std::string> determined;  ///< by those held before: nothing of them is left
};

/// Sequential information analysis (Wang & Bilger, 1973, J. Acoust. Soc. Am. 54, 1248-1266). In
/// each round the feature of which the largest part came through is held: from then on only
/// responses count that agree with their stimulus in it, and information is that within each of
/// its values. p is a part of all analysed responses in every round: what drops out is not made up
/// for (so that T and H, but not T / H, are those of fewer and fewer responses).
[[nodiscard]] Sinfa sinfa(const ConfusionMatrix& matrix, std::span<const Feature> features);

}  // namespace bimodal::analysis
