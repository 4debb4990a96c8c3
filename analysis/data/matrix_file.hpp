#pragma once

#include <filesystem>
#include <string_view>

#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// A confusion matrix from anywhere, as CSV: the first line has the responses, from its second
/// field on; each line after it a stimulus and how often it got each of them. Labels are kept as
/// they are written, "NA" too. Throws Error, naming file and line, for text that is no such matrix:
/// not UTF-8, labels that are empty or occur twice, a line of another length, counts that are not
/// whole numbers from 0 to 1e9.
[[nodiscard]] ConfusionMatrix parse_matrix(std::string_view text, std::string_view file);

/// The same of a file.
[[nodiscard]] ConfusionMatrix read_matrix(const std::filesystem::path& file);

}  // namespace bimodal::analysis
