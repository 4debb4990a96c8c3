#include "stimuli/base/json_text.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "stimuli/base/json_lines.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal {

namespace {

using Json = nlohmann::json;

unsigned byte_at(std::string_view text, std::size_t index) {
  return static_cast<unsigned char>(text[index]);
}

TextFault fault_at(std::string_view text,
                   std::size_t byte,
                   std::string finding,
                   std::string remedy) {
  return {position_of(text, byte).line, std::move(finding), std::move(remedy)};
}

std::optional<TextFault> fault_of_encoding(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    return TextFault{1, "the file is UTF-16", "save it as UTF-8"};
  }
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '\0') {
      return fault_at(text, at, "a NUL byte", "save the file as plain text in UTF-8");
    }
    const std::size_t length = utf8_length(text, at);
    if (length == 0) {
      return fault_at(text,
                      at,
                      fmt::format("byte 0x{:02X} at column {} is not UTF-8",
                                  byte_at(text, at),
                                  position_of(text, at).column),
                      "save the file as UTF-8");
    }
    at += length;
  }
  return std::nullopt;
}

/// Counts brackets and commas outside strings, before the parser builds anything.
std::optional<TextFault> fault_of_shape(std::string_view text, std::size_t most_values) {
  std::size_t depth = 0;
  std::size_t values = 1;
  bool in_string = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char letter = text[at];
    if (in_string) {
      if (letter == '\\') ++at;
      in_string = letter != '"';
      continue;
    }
    in_string = letter == '"';
    const bool opens = letter == '[' || letter == '{';
    if (opens) ++depth;
    if ((letter == ']' || letter == '}') && depth > 0) --depth;
    if (opens || letter == ',') ++values;
    if (depth > kDeepestNesting) {
      return fault_at(text,
                      at,
                      fmt::format("more than {} objects and arrays in each other", kDeepestNesting),
                      "a protocol needs four; is a bracket missing?");
    }
    if (values > most_values) {
      return fault_at(text,
                      at,
                      fmt::format("more than {} values", most_values),
                      "is this the right file? Long lists belong in files of their own");
    }
  }
  return std::nullopt;
}

/// Hears the parser's complaint; keeps nothing else.
class Complaint : public nlohmann::json_sax<Json> {
 public:
  bool null() override { return true; }

  bool boolean(bool /*value*/) override { return true; }

  bool number_integer(number_integer_t /*value*/) override { return true; }

  bool number_unsigned(number_unsigned_t /*value*/) override { return true; }

  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }

  bool string(string_t& /*value*/) override { return true; }

  bool binary(binary_t& /*value*/) override { return true; }

  bool start_object(std::size_t /*elements*/) override { return true; }

  bool key(string_t& /*value*/) override { return true; }

  bool end_object() override { return true; }

  bool start_array(std::size_t /*elements*/) override { return true; }

  bool end_array() override { return true; }

  bool parse_error(std::size_t position,
                   const std::string& token,
                   const nlohmann::detail::exception& error) override {
    byte = position;
    last_token = token;
    message = error.what();
    return false;
  }

  std::size_t byte = 0;  ///< from 1: the last one read
  std::string last_token;
  std::string message;
};

constexpr std::string_view kLineAndColumn = "column ";

/// "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error while parsing
/// value - invalid literal; last read: 'tru}'; expected ..." without what we say ourselves.
std::string essence(const std::string& message) {
  std::string_view rest{message};
  if (const auto column = rest.find(kLineAndColumn); column != std::string_view::npos) {
    rest.remove_prefix(std::min(rest.find(": ", column), rest.size() - 2) + 2);
  }
  const auto read = rest.find("; last read: '");
  if (read == std::string_view::npos) return std::string{rest};
  const auto expected = rest.find("'; expected", read);
  std::string kept{rest.substr(0, read)};
  if (expected != std::string_view::npos) kept += rest.substr(expected + 1);
  return kept;
}

std::string remedy_for(const Complaint& complaint) {
  const auto says = [&](std::string_view part) {
    return complaint.message.find(part) != std::string::npos;
  };
  if (says("unexpected '}'; expected string literal") || says("unexpected ']'")) {
    return "remove the comma before the closing bracket, or close what was opened";
  }
  if (says("unexpected string literal; expected")) return "a comma is missing before it";
  if (says("unexpected end of input")) return "a closing bracket or quotation mark is missing";
  if (says("invalid literal")) {
    if (complaint.last_token.ends_with('/')) return "JSON has no comments: remove it";
    if (complaint.last_token.ends_with('\'')) return "put texts in double quotation marks";
    return "put texts and keys in double quotation marks";
  }
  if (says("control character")) return "close the text, or write \\n for a line break within it";
  if (says("number overflow")) return "give a number that a double can hold";
  return "mend it there or just before";
}

/// Where an unexpected text or number begins; of anything else, the last byte that was read.
std::size_t first_byte(const Complaint& complaint, std::string_view text) {
  const std::size_t end = std::min(complaint.byte, text.size());
  const std::size_t length = complaint.last_token.size();
  const bool is_literal = complaint.message.find("literal; expected") != std::string::npos ||
                          complaint.message.find("overflow") != std::string::npos;
  if (is_literal && length <= end && text.substr(end - length, length) == complaint.last_token) {
    return end - length;
  }
  return complaint.byte > 0 ? complaint.byte - 1 : 0;
}

TextFault fault_of_syntax(std::string_view text) {
  Complaint complaint;
  Json::sax_parse(text, &complaint);
  const std::size_t byte = first_byte(complaint, text);
  const TextPosition position = position_of(text, byte);
  const bool overflow = complaint.message.find("number overflow") != std::string::npos;
  auto finding =
      overflow
          ? fmt::format("the number {:.40} is too large", complaint.last_token)
          : fmt::format("not JSON: column {}: {}", position.column, essence(complaint.message));
  return {position.line, std::move(finding), remedy_for(complaint)};
}

std::string printed(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::variant<Json, TextFault> parse_json(std::string_view text, std::size_t most_values) {
  if (text.size() > kLargestFile) {
    return TextFault{
        0,
        fmt::format(
            "{} bytes are more than the {} MB that we read", text.size(), kLargestFile >> 20U),
        "is this the right file?"};
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return TextFault{0, "the file is empty", "write its JSON into it: { ... }"};
  }
  if (auto fault = fault_of_encoding(text)) return *fault;
  if (auto fault = fault_of_shape(text, most_values)) return *fault;
  try {
    return Json::parse(text);
  } catch (const Json::exception&) {
    return fault_of_syntax(text);
  }
}

std::string shown(const Json& value) {
  constexpr std::size_t kLongest = 60;
  if (value.is_object()) return value.empty() ? "{}" : "{...}";
  if (value.is_array()) return value.empty() ? "[]" : "[...]";
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    if (text.size() > kLongest) {
      std::size_t end = kLongest;
      while (end > 0 && (byte_at(text, end) & 0xC0U) == 0x80U) --end;
      auto shortened = printed(Json(text.substr(0, end)));
      shortened.insert(shortened.size() - 1, "...");
      return shortened;
    }
  }
  return printed(value);
}

}  // namespace bimodal
