#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/matrix_file.hpp"

namespace bimodal::analysis {

/// Says what is wrong with a file, at the place that is being read, and how to mend it. Throws, or
/// keeps it for later.
using Refusal = std::function<void(std::string_view finding, std::string_view remedy)>;

/// Labels of one axis of a matrix, in their order.
class LabelAxis {
 public:
  /// `what` is "stimulus" or "response", and lives on.
  explicit LabelAxis(std::string_view what) : what_{what} {}

  /// Refuses a label that is empty, has line breaks or other control characters, or is there.
  void add(std::string label, const Refusal& refuse);

  /// Of a label, which is added if it is not there.
  [[nodiscard]] std::size_t index_of(const std::string& label, const Refusal& refuse);

  [[nodiscard]] const std::vector<std::string>& labels() const { return labels_; }

 private:
  void judge(const std::string& label, const Refusal& refuse) const;

  std::string_view what_;
  std::vector<std::string> labels_;
  std::map<std::string, std::size_t, std::less<>> indices_;
};

/// What stands behind "NAME: " in each of the lines before a table that begin so.
[[nodiscard]] std::vector<std::string> remarks_called(std::string_view name,
                                                      const std::vector<std::string>& remarks);

/// A matrix with the title and the warnings in the lines before it.
[[nodiscard]] TitledMatrix titled(ConfusionMatrix matrix, const std::vector<std::string>& remarks);

/// A field that is a count, whole or in parts: from 0 to 1e9, blanks around it ignored.
[[nodiscard]] std::optional<double> matrix_count(std::string_view field);

/// Whether a number can be a count.
[[nodiscard]] bool is_matrix_count(double number);

/// What to write where a count is none.
inline constexpr std::string_view kCountRemedy = "write how often it was given: a number from 0 on";

/// Whether these look like row proportions: they are not whole, and every row that is not empty
/// makes 1, as nearly as two decimals tell.
[[nodiscard]] bool are_proportions(const ConfusionMatrix& matrix);

}  // namespace bimodal::analysis
