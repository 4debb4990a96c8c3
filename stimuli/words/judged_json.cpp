#include "stimuli/words/judged_json.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/json_line.hpp"

namespace bimodal {

namespace {

using nlohmann::json;

/// The parser's own words without its number.
std::string reason(const json::parse_error& error) {
  const std::string_view what = error.what();
  const auto colon = what.find(": ");
  return std::string{colon == std::string_view::npos ? what : what.substr(colon + 2)};
}

}  // namespace

JudgedJson::JudgedJson(const std::filesystem::path& file, std::vector<Diagnostic>& diagnostics)
    : file_{file.string()}, diagnostics_{&diagnostics} {}

std::optional<json> JudgedJson::parse() {
  Diagnostic diagnostic{.severity = Severity::Error,
                        .file = file_,
                        .line = 0,
                        .pointer = {},
                        .finding = {},
                        .remedy = {}};
  try {
    text_ = read_file(file_);
    return json::parse(text_);
  } catch (const Error& error) {
    diagnostic.finding = error.what();
  } catch (const json::parse_error& error) {
    // The parser counts from 1, and stands behind the byte that it did not like.
    diagnostic.line = line_of_offset(text_, error.byte > 0 ? error.byte - 1 : 0);
    diagnostic.finding = fmt::format("not JSON: {}", reason(error));
    diagnostic.remedy = "mend the JSON at this place or just before it";
  }
  diagnostics_->push_back(std::move(diagnostic));
  return std::nullopt;
}

void JudgedJson::find(const std::string& pointer,
                      std::string finding,
                      std::string remedy,
                      Severity severity) {
  diagnostics_->push_back({.severity = severity,
                           .file = file_,
                           .line = line_of_pointer(text_, pointer).value_or(0),
                           .pointer = pointer,
                           .finding = std::move(finding),
                           .remedy = std::move(remedy)});
}

void JudgedJson::warn_of_unknown_keys(const json& object,
                                      const std::string& pointer,
                                      std::span<const std::string_view> known) {
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    find(fmt::format("{}/{}", pointer, escaped(key)),
         fmt::format("nothing reads {}", shown(key)),
         fmt::format("leave it out; known here are {}", fmt::join(known, ", ")),
         Severity::Warning);
  }
}

std::optional<std::string> JudgedJson::text_at(const json& object,
                                               const std::string& pointer,
                                               std::string_view key,
                                               const std::string& remedy) {
  const auto found = object.find(key);
  if (found == object.end()) {
    find(pointer, fmt::format("there is no \"{}\"", key), remedy);
    return std::nullopt;
  }
  if (!found->is_string() || found->get_ref<const std::string&>().empty()) {
    find(fmt::format("{}/{}", pointer, key), fmt::format("{} is no text", shown(*found)), remedy);
    return std::nullopt;
  }
  return found->get<std::string>();
}

std::string shown(const json& value) {
  constexpr std::size_t kLongest = 40;
  if (value.is_object()) return value.empty() ? "an empty object" : "an object";
  if (value.is_array()) return value.empty() ? "an empty array" : "an array";
  std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  return text;
}

std::string escaped(std::string_view key) {
  std::string token;
  for (const char letter : key) {
    if (letter == '~') {
      token += "~0";
    } else if (letter == '/') {
      token += "~1";
    } else {
      token += letter;
    }
  }
  return token;
}

}  // namespace bimodal
