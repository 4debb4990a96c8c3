#include "stimuli/words/judged_json.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

using nlohmann::json;

}  // namespace

JudgedJson::JudgedJson(const std::filesystem::path& file, std::vector<Diagnostic>& diagnostics)
    : file_{file.string()}, diagnostics_{&diagnostics} {}

std::optional<json> JudgedJson::parse() {
  const auto refuse = [this](std::size_t line, std::string finding, std::string remedy) {
    diagnostics_->push_back({.severity = Severity::Error,
                             .file = file_,
                             .line = line,
                             .pointer = {},
                             .finding = std::move(finding),
                             .remedy = std::move(remedy)});
    return std::nullopt;
  };
  std::string text;
  try {
    text = read_file(file_);
  } catch (const Error& error) {
    return refuse(0, error.what(), {});
  }
  auto parsed = parse_json(text);
  if (auto* fault = std::get_if<TextFault>(&parsed)) {
    return refuse(fault->line, std::move(fault->finding), std::move(fault->remedy));
  }
  lines_.emplace(text);
  return std::get<json>(std::move(parsed));
}

void JudgedJson::find(const std::string& pointer,
                      std::string finding,
                      std::string remedy,
                      Severity severity) {
  diagnostics_->push_back({.severity = severity,
                           .file = file_,
                           .line = lines_ ? lines_->line_of(pointer) : 0,
                           .pointer = pointer,
                           .finding = std::move(finding),
                           .remedy = std::move(remedy)});
}

void JudgedJson::warn_of_unknown_keys(const json& object,
                                      const std::string& pointer,
                                      std::span<const std::string_view> known) {
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    find(fmt::format("{}/{}", pointer, escape_pointer(key)),
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

}  // namespace bimodal
