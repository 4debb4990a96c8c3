#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "stimuli/base/diagnostic.hpp"

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
  std::string text_;
  std::vector<Diagnostic>* diagnostics_;
};

/// A value as it may stand in a message: short, and ASCII whatever was read.
[[nodiscard]] std::string shown(const nlohmann::json& value);

/// A key as a part of an RFC 6901 pointer.
[[nodiscard]] std::string escaped(std::string_view key);

}  // namespace bimodal
