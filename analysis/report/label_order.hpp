#pragma once

#include <string_view>

#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// How the rows and columns of a printed matrix follow each other.
enum class LabelOrder {
  /// As the data have them.
  Given,
  /// Phones by place of articulation, front to back, vowels behind the consonants; what is no phone
  /// of the ARPAbet comes last, as given.
  Place,
  /// Stimuli as the dendrogram of average linkage draws them (phi dissimilarity), those never
  /// presented last; the responses of the same names likewise, then the others as given.
  Clusters,
};

/// The order as a header or note tells it: "as given".
[[nodiscard]] std::string_view in_words(LabelOrder order);

/// The same counts in another order. Throws Error if no label is a phone that has a place.
[[nodiscard]] ConfusionMatrix reordered(const ConfusionMatrix& matrix, LabelOrder order);

}  // namespace bimodal::analysis
