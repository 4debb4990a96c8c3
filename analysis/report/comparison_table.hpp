#pragma once

#include <string>

#include "analysis/report/face_comparison.hpp"

namespace bimodal::analysis {

/// Contrasts that lose less phi than this are not told in words.
inline constexpr double kLossWorthTelling = 0.10;

/// For people: how much is right, how alike the confusions are and how alike they could be, the
/// test, the cells that differ, and in words what the second face fails to show.
[[nodiscard]] std::string comparison_text(const FaceComparison& comparison);

/// Every cell: stimulus, response, counts and proportions of both, difference, p and q.
[[nodiscard]] std::string comparison_csv(const FaceComparison& comparison);

/// Every figure in full precision.
[[nodiscard]] std::string comparison_json(const FaceComparison& comparison);

/// "Initial consonants: natural tells F and P apart (phi .95, confused .02); synthetic hardly (phi
/// .31, confused .40)": one of the ranked contrasts.
[[nodiscard]] std::string contrast_in_words(const Contrast& contrast,
                                            const std::string& one,
                                            const std::string& other);

/// What the permutation exchanged, in words.
[[nodiscard]] std::string design_in_words(const FaceComparison& comparison);

}  // namespace bimodal::analysis
