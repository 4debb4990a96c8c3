#pragma once

#include <span>
#include <string>
#include <string_view>

#include "analysis/report/attachment.hpp"
#include "analysis/report/page.hpp"
#include "analysis/report/results.hpp"

namespace bimodal::analysis {

/// Numbers the page's figures in their order.
class FigureNumbers {
 public:
  [[nodiscard]] int next() { return ++last_; }

 private:
  int last_ = 0;
};

/// The parts of the report's page, each an HTML fragment.

[[nodiscard]] std::string_view page_style();
[[nodiscard]] std::string part_of_warnings(const Results& results);
[[nodiscard]] std::string part_of_words(const Results& results, FigureNumbers& numbers);
[[nodiscard]] std::string part_of_proportions(const Results& results);
[[nodiscard]] std::string part_of_benefits(const Results& results, FigureNumbers& numbers);
[[nodiscard]] std::string part_of_faces(const Results& results, FigureNumbers& numbers);
[[nodiscard]] std::string part_of_features(const Results& results, FigureNumbers& numbers);
[[nodiscard]] std::string part_of_confusions(const Results& results, FigureNumbers& numbers);
[[nodiscard]] std::string part_of_structure(const Results& results, FigureNumbers& numbers);
[[nodiscard]] std::string part_of_likeness(const Results& results);
[[nodiscard]] std::string part_of_attachments(std::span<const Attachment> attachments);
[[nodiscard]] std::string part_of_data(const Results& results);
[[nodiscard]] std::string part_of_methods(const Results& results);
[[nodiscard]] std::string part_of_reproduction(const Results& results, const Making& making);

/// What was done as a paragraph for a paper, and what it refers to.
[[nodiscard]] std::string part_for_paper(const Results& results, const Making& making);

/// All trials as data, and the script that lists those of a cell of a confusion matrix.
[[nodiscard]] std::string part_of_trials(const Results& results);
[[nodiscard]] std::string_view page_script();

/// ".55 [.50, .60]", or the proportion alone, or a dash.
[[nodiscard]] std::string print_estimate(const Proportion& proportion);

/// "&#8722;.12": a correlation, proportion or difference without leading zero, or a dash.
[[nodiscard]] std::string print_signed(const std::optional<double>& value);

/// "&#8722;.12 [&#8722;.30, .05]"; without interval the value alone.
[[nodiscard]] std::string print_signed(const std::optional<double>& value,
                                       const std::optional<Interval>& interval);

}  // namespace bimodal::analysis
