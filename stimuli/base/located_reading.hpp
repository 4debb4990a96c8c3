#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "stimuli/base/diagnostic.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/base/json_lines.hpp"
#include "stimuli/base/json_text.hpp"

namespace bimodal {

/// Parses an untrusted JSON text and lets `read(tree, findings)` make something of it. All that is
/// wrong (no JSON, keys twice, what `read` found) is added to `diagnostics` with file and line;
/// absent if any of it is an error.
template <typename Read>
[[nodiscard]] auto read_located(std::string_view text,
                                std::string_view file,
                                std::vector<Diagnostic>& diagnostics,
                                std::size_t most_values,
                                Read read)
    -> std::optional<decltype(read(std::declval<const nlohmann::json&>(),
                                   std::declval<Findings&>()))> {
  const auto parsed = parse_json(text, most_values);
  if (const auto* fault = std::get_if<TextFault>(&parsed)) {
    diagnostics.push_back({.file = std::string{file},
                           .line = fault->line,
                           .pointer = "",
                           .finding = fault->finding,
                           .remedy = fault->remedy});
    return std::nullopt;
  }
  const JsonLines lines{text};
  Findings findings;
  findings.refuse_duplicates(lines);
  auto result = read(std::get<nlohmann::json>(parsed), findings);
  const auto located = findings.located(lines, std::string{file});
  diagnostics.insert(diagnostics.end(), located.begin(), located.end());
  if (has_errors(located)) return std::nullopt;
  return result;
}

}  // namespace bimodal
