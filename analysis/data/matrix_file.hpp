#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// How matrices lie in files, in the words of those that say so.
inline constexpr std::string_view kOrientation = "rows are stimuli, columns are responses";

/// A confusion matrix, and what its file says of it.
struct TitledMatrix {
  std::string title;                  ///< empty: the file does not say
  std::vector<std::string> warnings;  ///< "SIMULATED sessions are among the data"
  ConfusionMatrix matrix;
};

/// A confusion matrix from anywhere, in one of four forms, told apart by how the text begins:
///
/// - CSV as a table: the first line has the responses, from its second field on; each line after it
///   a stimulus and how often it got each of them.
/// - CSV as a list: a line for each stimulus and response, in the columns "stimulus", "response"
///   and "count"; others are passed over. A pair that has no line was never given.
/// - JSON: an object with "stimuli", "responses" and "counts" (a list for each stimulus), perhaps
///   "title", "warnings" and "orientation"; other keys are passed over.
/// - Praat's text files of a Confusion, a ContingencyTable or a TableOfReal.
///
/// Before CSV, lines may stand that begin with "# ": "# title: ..." is the title, "# warning: ..."
/// a warning; so with "! " in Praat's files. Labels are kept as they are written, "NA" too; each is
/// one line. Counts are numbers from 0 to 1e9, whole, or in parts where responses were shared out
/// between cells. Throws Error, naming file and line, for text that is no such matrix, and for a
/// table whose rows all make 1 and that does not say "# cells: counts": these are proportions, of
/// which no count comes back.
[[nodiscard]] TitledMatrix parse_titled_matrix(std::string_view text, std::string_view file);

/// The same without its title.
[[nodiscard]] ConfusionMatrix parse_matrix(std::string_view text, std::string_view file);

/// The same of files.
[[nodiscard]] TitledMatrix read_titled_matrix(const std::filesystem::path& file);
[[nodiscard]] ConfusionMatrix read_matrix(const std::filesystem::path& file);

}  // namespace bimodal::analysis
