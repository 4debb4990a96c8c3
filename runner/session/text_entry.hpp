#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace bimodal::runner {

/// A line of text being typed. Whole Unicode code points are added and removed; control characters
/// and malformed UTF-8 are refused.
class TextEntry {
 public:
  /// At most `longest` code points.
  explicit TextEntry(std::size_t longest) : longest_{longest} {}

  void type(std::string_view utf8);

  /// Removes the last code point, if there is one.
  void erase();

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::size_t longest_;
  std::size_t length_ = 0;  // code points
  std::string text_;
};

}  // namespace bimodal::runner
