#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bimodal {

/// Takes records off an untrusted CSV text, field by field (RFC 4180, section 2; lines may also end
/// in a line feed alone, and a byte-order mark may come first). Fields are text and never
/// interpreted: "NA" is a syllable. Throws Error, naming file and line.
class CsvReader {
 public:
  /// Both texts outlive the reader. Fields end at the delimiter; 0: at commas, or at semicolons (as
  /// in many countries) or tabs if the first line that is no remark ("# ...") has these and no
  /// comma.
  CsvReader(std::string_view text, std::string_view file, char delimiter = '\0');

  /// Takes the lines off that begin with "# " before the first record, and gives them without that
  /// mark: what a program says of the table that follows. A field that begins so is in quotation
  /// marks, or not in the first line.
  [[nodiscard]] std::vector<std::string> take_remarks();

  /// The fields of the next line that is not empty; absent after the last one.
  [[nodiscard]] std::optional<std::vector<std::string>> next();

  /// Where the record begins that next() gave last; from 1.
  [[nodiscard]] std::size_t line() const { return line_; }

  /// Throws Error about that record.
  [[noreturn]] void refuse(std::string_view finding, std::string_view remedy) const;

 private:
  void step();
  [[nodiscard]] bool at_end_of_line() const;
  [[nodiscard]] std::string take_field();
  [[nodiscard]] std::string take_quoted_field();

  std::string_view text_;
  std::string_view file_;
  char delimiter_;
  std::size_t at_ = 0;
  std::size_t reached_line_ = 1;
  std::size_t line_ = 1;
};

/// A field that is a count: a whole number from 0 to 1e9, blanks around it ignored.
[[nodiscard]] std::optional<std::int64_t> csv_count(std::string_view field);

}  // namespace bimodal
