#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bimodal::analysis {

/// What a trial has, as tables of trials and mappings name it. "stimulus" is the word presented,
/// "response_ms" counts to the submission, "first_key_ms" to the first key.
inline constexpr std::array<std::string_view, 20> kTrialFields{
    "participant",   "session",   "trial",       "phase",        "block",
    "condition",     "stimulus",  "response",    "phones",       "auditory_talker",
    "visual_talker", "snr_db",    "visual_word", "articulation", "first_key_ms",
    "response_ms",   "timed_out", "flagged",     "excluded",     "simulated"};

/// How somebody else's table of trials is to be read: a JSON file such as
///
///     {"columns": {"participant": "Subj", "condition": ["modality", "talker"],
///                  "stimulus": "Target", "response": "Typed"},
///      "values": {"condition": {"V nat": "natural"}, "response": {"(none)": ""}},
///      "constants": {"phase": "main"}, "delimiter": ";"}
///
/// A field made of several columns joins their texts by a blank. `values` replaces whole texts,
/// after joining. What is not mapped is looked for under the field's own name, capitals or not.
struct TrialMapping {
  std::map<std::string, std::vector<std::string>> columns;           ///< by field
  std::map<std::string, std::map<std::string, std::string>> values;  ///< by field
  std::map<std::string, std::string> constants;                      ///< by field
  char delimiter = '\0';  ///< ',', ';' or a tab; 0: whichever the first line has
};

/// Throws Error with every mistake: file, line, JSON pointer, remedy.
[[nodiscard]] TrialMapping parse_mapping(std::string_view text, const std::string& file);

/// The same of a file.
[[nodiscard]] TrialMapping read_mapping(const std::filesystem::path& file);

}  // namespace bimodal::analysis
