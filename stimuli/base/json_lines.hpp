#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bimodal {

/// A place in a text, both from 1; columns count characters (code points).
struct TextPosition {
  std::size_t line = 1;
  std::size_t column = 1;

  bool operator==(const TextPosition&) const = default;
};

/// Where a byte of a UTF-8 text stands; a byte beyond the end stands just behind the last one.
[[nodiscard]] TextPosition position_of(std::string_view text, std::size_t byte);

/// A part of an RFC 6901 pointer with "~" and "/" escaped.
[[nodiscard]] std::string escape_pointer(std::string_view key);

/// A key that one object has more than once.
struct DuplicateKey {
  std::string pointer;           ///< RFC 6901
  std::size_t line = 0;          ///< of the repetition
  std::size_t earlier_line = 0;  ///< of the one before it
};

/// On which line each value of a JSON text stands, which the JSON library does not tell: a member
/// of an object where its key is, anything else where it begins. Memory is proportional to the
/// text.
class JsonLines {
 public:
  /// `json` is valid JSON (the parser has accepted it); a byte order mark may precede it.
  explicit JsonLines(std::string_view json);

  /// Line of the value at an RFC 6901 pointer, from 1; of its nearest enclosing value where it
  /// does not exist. Of keys given twice, the last one counts, as for the parser.
  [[nodiscard]] std::size_t line_of(std::string_view pointer) const;

  [[nodiscard]] const std::vector<DuplicateKey>& duplicates() const { return duplicates_; }

 private:
  class Scan;

  std::vector<std::size_t> lines_;  ///< of every value, in the order of the text
  std::map<std::pair<std::size_t, std::string>, std::size_t> children_;  ///< (parent, key) -> value
  std::vector<DuplicateKey> duplicates_;
};

}  // namespace bimodal
