#pragma once

#include <filesystem>
#include <string_view>

#include "analysis/data/gathering.hpp"
#include "analysis/data/trial_mapping.hpp"

namespace bimodal::analysis {

/// Whether the first line of a CSV names a stimulus (or word) and a response, so that the file is a
/// table of trials and not a confusion matrix.
[[nodiscard]] bool is_trial_table(std::string_view text);

/// Trials from anywhere, as CSV with a line for each: a column "stimulus" (or "word") and a column
/// "response"; "participant", "condition" and every other field of kTrialFields where there is one.
/// A table of trials that `report` wrote is one. Text is never interpreted: "NA" is a syllable; but
/// in columns of numbers "NA" and nothing mean that there is none. A trial without condition
/// belongs to "all"; where no column names participants, all trials are one's, "1". Phones may be
/// given as ARPAbet; else they stay empty until a lexicon is asked. Throws Error, naming file and
/// line.
[[nodiscard]] TrialsOfFile parse_trials(std::string_view text,
                                        std::string_view file,
                                        const TrialMapping& mapping = {});

/// The same of a file.
[[nodiscard]] TrialsOfFile read_trials(const std::filesystem::path& file,
                                       const TrialMapping& mapping = {});

}  // namespace bimodal::analysis
