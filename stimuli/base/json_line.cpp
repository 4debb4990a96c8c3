#include "stimuli/base/json_line.hpp"

#include <algorithm>
#include <string>

namespace bimodal {

namespace {

/// Walks over JSON text without building anything. Every step returns false at the end of the text
/// or at something that is not JSON.
class Walk {
 public:
  explicit Walk(std::string_view text) : text_{text} {}

  [[nodiscard]] std::size_t offset() const { return at_; }

  /// Goes to the beginning of the value that the pointer names, from the beginning of another.
  bool to_pointer(std::string_view pointer) {
    space();
    while (!pointer.empty()) {
      if (pointer.front() != '/') return false;
      pointer.remove_prefix(1);
      const std::string token = unescaped(pointer.substr(0, pointer.find('/')));
      pointer.remove_prefix(std::min(pointer.find('/'), pointer.size()));
      if (!to_member(token)) return false;
      space();
    }
    return at_ < text_.size();
  }

 private:
  static std::string unescaped(std::string_view token) {
    std::string plain;
    for (std::size_t i = 0; i < token.size(); ++i) {
      const bool escape = token[i] == '~' && i + 1 < token.size();
      plain += !escape ? token[i] : token[++i] == '1' ? '/' : '~';
    }
    return plain;
  }

  /// From "{" or "[" to the value of a key or of an index.
  bool to_member(const std::string& token) {
    if (at_ >= text_.size() || (text_[at_] != '{' && text_[at_] != '[')) return false;
    const bool object = text_[at_] == '{';
    ++at_;
    std::optional<std::size_t> found;
    for (std::size_t index = 0; space() && text_[at_] != '}' && text_[at_] != ']'; ++index) {
      std::string name = std::to_string(index);
      if (object && !key(name)) return false;
      if (name == token) found = at_;
      if (!value()) return false;
      if (space() && text_[at_] == ',') ++at_;
    }
    if (found.has_value()) at_ = *found;
    return found.has_value();
  }

  /// Over `"name" :`; escapes other than \" \\ \/ are kept as they are written.
  bool key(std::string& name) {
    const std::size_t start = at_;
    if (!string()) return false;
    name.clear();
    for (std::size_t i = start + 1; i + 1 < at_; ++i) {
      const bool plain = text_[i] == '\\' && std::string_view{"\"\\/"}.find(text_[i + 1]) != kNone;
      name += text_[plain ? ++i : i];
    }
    if (!space() || text_[at_] != ':') return false;
    ++at_;
    return space();
  }

  bool space() {
    while (at_ < text_.size() && std::string_view{" \t\r\n"}.find(text_[at_]) != kNone) ++at_;
    return at_ < text_.size();
  }

  bool string() {
    if (at_ >= text_.size() || text_[at_] != '"') return false;
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    if (at_ >= text_.size()) return false;
    ++at_;
    return true;
  }

  /// Over one whole value, by counting brackets.
  bool value() {
    std::size_t depth = 0;
    do {
      if (!space()) return false;
      const char sign = text_[at_];
      if (sign == '"') {
        if (!string()) return false;
      } else if (sign == '{' || sign == '[') {
        ++depth;
        ++at_;
      } else if (sign == '}' || sign == ']') {
        if (depth == 0) return false;
        --depth;
        ++at_;
      } else if (sign == ',' || sign == ':') {
        if (depth == 0) return false;
        ++at_;
      } else {
        at_ = std::min(text_.find_first_of(" \t\r\n,:]}\"[{", at_), text_.size());
      }
    } while (depth > 0);
    return true;
  }

  static constexpr auto kNone = std::string_view::npos;
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::size_t line_of_offset(std::string_view text, std::size_t offset) {
  return 1 + static_cast<std::size_t>(std::ranges::count(text.substr(0, offset), '\n'));
}

std::optional<std::size_t> line_of_pointer(std::string_view text, std::string_view pointer) {
  Walk walk{text};
  if (!walk.to_pointer(pointer)) return std::nullopt;
  return line_of_offset(text, walk.offset());
}

}  // namespace bimodal
