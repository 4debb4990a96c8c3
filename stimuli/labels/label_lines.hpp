#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace bimodal {

/// Where in a label file something stands, for messages.
struct LabelLine {
  std::string_view file;
  std::size_t number = 0;  ///< from 1; 0: the whole file
};

/// Throws Error "file:line: finding; remedy".
[[noreturn]] void refuse(const LabelLine& line, std::string_view finding, std::string_view remedy);

/// A text without the blanks (space, tab, line break) at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Whether it is well-formed UTF-8 without NUL, and its lines end in '\n' alone.
[[nodiscard]] bool is_plain_text(std::string_view text);

/// Takes the first word, up to a blank, off the text; empty if there is none. What is left begins
/// with the next word.
std::string_view take_word(std::string_view& text);

/// A part of a text for a message: at most about 40 bytes, in quotation marks, control
/// characters as blanks.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// The lines of a text one after the other, numbered from 1.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_{text} {}

  /// The next line without its '\n'; absent after the last one.
  std::optional<std::string_view> next();

  /// Of the line that `next` gave last.
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

}  // namespace bimodal
