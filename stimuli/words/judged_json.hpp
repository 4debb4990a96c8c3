#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "stimuli/base/diagnostic.hpp"
#include "stimuli/base/json_lines.hpp"
#include "stimuli/base/json_text.hpp"

namespace bimodal {

/// A JSON file that is being judged: every finding about it goes, with the line on which it stands,
/// into the list of the caller, which must outlive this.
class JudgedJson {
 public:
  JudgedJson(const std::filesystem::path& file, std::vector<Diagnostic>& diagnostics);

  /// The parsed file; absent, with a finding, if it cannot be read or is not JSON.
  [[nodiscard]] std::optional<nlohmann::json> parse();

  void find(const std::string& pointer,
            std::string finding,
            std::string remedy,
            Severity severity = Severity::Error);

  /// A warning for each key of the object at `pointer` that is not among `known`.
  void warn_of_unknown_keys(const nlohmann::json& object,
                            const std::string& pointer,
                            std::span<const std::string_view> known);

  /// The string under a key; absent, with a finding, if it is missing, empty or no string.
  [[nodiscard]] std::optional<std::string> text_at(const nlohmann::json& object,
                                                   const std::string& pointer,
                                                   std::string_view key,
                                                   const std::string& remedy);

 private:
  std::string file_;
  std::optional<JsonLines> lines_;  ///< once it has been parsed
  std::vector<Diagnostic>* diagnostics_;
};

}  // namespace bimodal
