#include "stimuli/base/json_lines.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace bimodal {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool continues_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

std::string unescape_pointer(std::string_view part) {
  std::string key;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i] == '~' && i + 1 < part.size()) {
      key += part[++i] == '1' ? '/' : '~';
    } else {
      key += part[i];
    }
  }
  return key;
}

}  // namespace

TextPosition position_of(std::string_view text, std::size_t byte) {
  TextPosition position;
  if (text.starts_with(kByteOrderMark)) {
    text.remove_prefix(kByteOrderMark.size());
    byte -= std::min(byte, kByteOrderMark.size());
  }
  for (const char letter : text.substr(0, byte)) {
    if (letter == '\n') {
      ++position.line;
      position.column = 1;
    } else if (!continues_character(letter)) {
      ++position.column;
    }
  }
  return position;
}

std::string escape_pointer(std::string_view key) {
  std::string part;
  for (const char letter : key) {
    if (letter == '~') {
      part += "~0";
    } else if (letter == '/') {
      part += "~1";
    } else {
      part += letter;
    }
  }
  return part;
}

/// One pass over the text; recursion is as deep as the text, which the caller has limited.
class JsonLines::Scan {
 public:
  Scan(std::string_view json, JsonLines& lines) : json_{json}, lines_{&lines} {
    if (json_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  }

  void whole() {
    skip_space();
    lines_->lines_.push_back(line_);
    value(0);
  }

 private:
  [[nodiscard]] char here() const { return at_ < json_.size() ? json_[at_] : '\0'; }

  void skip_space() {
    for (; at_ < json_.size(); ++at_) {
      if (here() == '\n') {
        ++line_;
      } else if (here() != ' ' && here() != '\t' && here() != '\r') {
        return;
      }
    }
  }

  /// The string literal that begins here, with its quotation marks.
  std::string_view string() {
    const std::size_t begin = at_++;
    while (at_ < json_.size() && here() != '"') at_ += here() == '\\' ? 2U : 1U;
    ++at_;
    return json_.substr(begin, at_ - begin);
  }

  void value(std::size_t self) {
    if (here() == '{') {
      members(self);
    } else if (here() == '[') {
      elements(self);
    } else if (here() == '"') {
      string();
    } else {
      at_ = std::min(json_.find_first_of(" \t\r\n,]}", at_), json_.size());
    }
  }

  /// Steps over the opening bracket or the comma before an item and returns whether there is one;
  /// if not, steps over the closing bracket.
  bool next_item(char closing) {
    skip_space();
    if (here() != closing) {
      ++at_;
      skip_space();
    }
    if (at_ < json_.size() && here() != closing) return true;
    ++at_;
    return false;
  }

  void members(std::size_t object) {
    while (next_item('}')) {
      const std::size_t line = line_;
      auto key = nlohmann::json::parse(string()).get<std::string>();
      skip_space();
      ++at_;  // the colon
      skip_space();
      const auto earlier = lines_->children_.find({object, key});
      path_.push_back(key);
      if (earlier != lines_->children_.end()) {
        lines_->duplicates_.push_back({path(), line, lines_->lines_[earlier->second]});
      }
      child(object, std::move(key), line);
      path_.pop_back();
    }
  }

  void elements(std::size_t array) {
    for (std::size_t index = 0; next_item(']'); ++index) {
      path_.push_back(std::to_string(index));
      child(array, path_.back(), line_);
      path_.pop_back();
    }
  }

  void child(std::size_t parent, std::string key, std::size_t line) {
    const std::size_t self = lines_->lines_.size();
    lines_->lines_.push_back(line);
    lines_->children_.insert_or_assign({parent, std::move(key)}, self);
    value(self);
  }

  [[nodiscard]] std::string path() const {
    std::string pointer;
    for (const auto& key : path_) pointer.append("/").append(escape_pointer(key));
    return pointer;
  }

  std::string_view json_;
  JsonLines* lines_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::vector<std::string> path_;  ///< keys and indices from the whole to the present value
};

JsonLines::JsonLines(std::string_view json) {
  Scan{json, *this}.whole();
}

std::size_t JsonLines::line_of(std::string_view pointer) const {
  std::size_t self = 0;
  while (pointer.starts_with('/')) {
    pointer.remove_prefix(1);
    const std::size_t end = std::min(pointer.find('/'), pointer.size());
    const auto found = children_.find({self, unescape_pointer(pointer.substr(0, end))});
    if (found == children_.end()) break;
    self = found->second;
    pointer.remove_prefix(end);
  }
  return lines_[self];
}

}  // namespace bimodal
