#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "stimuli/base/quantity.hpp"
#include "stimuli/labels/label_lines.hpp"

namespace bimodal {

/// Reads the values of a Praat text file one after the other, as Praat does: free-standing numbers,
/// "strings" (with "" for a quotation mark) and <flags>; everything else, names as well as "!" and
/// the rest of its line, is comment. So the long and the short form are one. (Praat manual,
/// "TextGrid file formats", "Shorter shorter": only the order of the values counts.)
///
/// Each function takes the next value; `what` says what it should be, e.g. "the name of a tier".
/// They throw Error, naming the line, if it is of another kind, malformed, or not there.
class PraatText {
 public:
  /// `text` and `file` must live on.
  PraatText(std::string_view text, std::string_view file) : text_{text}, file_{file} {}

  [[nodiscard]] std::string take_string(std::string_view what);
  [[nodiscard]] Duration take_seconds(std::string_view what);
  [[nodiscard]] std::size_t take_count(std::string_view what);
  /// Any finite number.
  [[nodiscard]] double take_number(std::string_view what);
  /// What stands between "<" and ">".
  [[nodiscard]] std::string take_flag(std::string_view what);

  /// Whether no value is left.
  [[nodiscard]] bool at_end();

  /// Of the value that was taken last.
  [[nodiscard]] LabelLine line() const { return {file_, value_line_}; }

 private:
  enum class Kind { Number, String, Flag, Nothing };

  [[nodiscard]] Kind find_value();
  void expect(Kind kind, std::string_view what);
  [[nodiscard]] std::string_view take_word();
  void skip_while(bool (*is_skipped)(char));

  std::string_view text_;
  std::string_view file_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;        ///< of at_
  std::size_t value_line_ = 1;  ///< where the last value begins
};

}  // namespace bimodal
