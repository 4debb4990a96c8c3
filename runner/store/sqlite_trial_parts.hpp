#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "runner/store/records.hpp"
#include "runner/store/sqlite.hpp"

namespace bimodal::runner {

/// Trials that were read, by session and trial. Borrowed.
using TrialsById = std::map<std::pair<std::int64_t, std::int64_t>, TrialRecord*>;

/// Reads what belongs to trials from tables of its own (onsets, sounds, recordings, keystrokes,
/// clock maps, triggers, events) into them; `version` of the schema says which tables there are.
void read_trial_parts(Database& database, std::int64_t version, const TrialsById& trials);

}  // namespace bimodal::runner
