#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bimodal::analysis {

/// So many of so many, and what the file says of them.
struct CountedSuccesses {
  std::vector<std::string> labels;  ///< the line's other fields, in their order
  std::int64_t successes = 0;
  std::int64_t trials = 0;
};

struct CountsTable {
  std::vector<std::string> labels;  ///< names of the other columns
  std::vector<CountedSuccesses> rows;
};

/// Counts as CSV, with a column "k" of successes and a column "n" of trials among its columns.
/// Throws Error, naming file and line; also where k > n.
[[nodiscard]] CountsTable parse_counts(std::string_view text, std::string_view file);

/// The same of a file.
[[nodiscard]] CountsTable read_counts(const std::filesystem::path& file);

/// Answers "yes" to signals and to noises.
struct CountedYes {
  std::vector<std::string> labels;  ///< the line's other fields, in their order
  std::int64_t hits = 0;
  std::int64_t signals = 0;
  std::int64_t false_alarms = 0;
  std::int64_t noises = 0;
};

struct YesTable {
  std::vector<std::string> labels;  ///< names of the other columns
  std::vector<CountedYes> rows;
};

/// The same as CSV with the columns "hits", "signals", "false_alarms" and "noises".
[[nodiscard]] YesTable parse_yes_counts(std::string_view text, std::string_view file);
[[nodiscard]] YesTable read_yes_counts(const std::filesystem::path& file);

/// Which of these tables a CSV is, by its first line (one with half of the columns too, so that it
/// can be said which is missing).
enum class CountsKind { None, Successes, Yes };

[[nodiscard]] CountsKind kind_of_counts(std::string_view text);

}  // namespace bimodal::analysis
