#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "analysis/data/stored_data.hpp"
#include "stimuli/words/dictionary.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::analysis::examples {

inline constexpr std::string_view kDictionaryText =
    "bat B AE T\nbed B EH D\nbee B IY\nblow B L OW\nbow B AW\nbow(2) B OW\ncan't K AE N T\n"
    "eight EY T\nate EY T\nlead L EH D\nlead(2) L IY D\nmat M AE T\npat P AE T\nread R EH D\n"
    "read(2) R IY D\nred R EH D\nreed R IY D\nrid R IH D\nstew S T UW\ntoo T UW\ntwo T UW\n"
    "tuna T UW N AH\nwell W EH L\nwe'll W IY L\n";

inline Dictionary dictionary(const WrittenFiles& folder) {
  return Dictionary{folder.write("words.dict", kDictionaryText)};
}

inline Pronunciation phones(std::string_view text) {
  Pronunciation read;
  std::istringstream symbols{std::string{text}};
  for (std::string symbol; symbols >> symbol;) read.push_back(phone_from_symbol(symbol).value());
  return read;
}

inline Trial trial(std::string word, std::string_view spoken, std::string response) {
  Trial made;
  made.participant = "P01";
  made.phase = "main";
  made.condition = "visual";
  made.word = std::move(word);
  made.phones = phones(spoken);
  made.response = std::move(response);
  return made;
}

/// A main trial of condition "auditory" that asked for `word` and was answered with `response`.
inline runner::StoredTrial stored_trial(int index,
                                        std::string word,
                                        std::string spoken,
                                        std::string response) {
  using namespace std::chrono_literals;
  runner::StoredTrial stored;
  stored.plan.trial = index;
  stored.plan.phase = "main";
  stored.plan.word = std::move(word);
  stored.plan.phones = std::move(spoken);
  stored.plan.condition = "auditory";
  stored.plan.auditory_talker = "festival:kal";
  stored.plan.snr_db = -8.0;
  stored.trial.trial = index;
  stored.trial.stimulus_start = 10s;
  stored.trial.stimulus_end = 12s;
  stored.trial.response.text = std::move(response);
  stored.trial.response.first_key = 12500ms;
  stored.trial.response.submitted = 13s;
  return stored;
}

inline runner::StoredSession session(std::string participant,
                                     std::vector<runner::StoredTrial> trials) {
  runner::StoredSession stored;
  stored.session.id = 1;
  stored.session.participant = std::move(participant);
  stored.session.protocol_title = "Words";
  stored.session.protocol_text = "{}";
  stored.session.protocol_sha256 = "abc";
  stored.session.started_utc = "2026-11-22T10:00:00Z";
  stored.outcome = "complete";
  stored.planned_trials = static_cast<int>(trials.size());
  stored.trials = std::move(trials);
  return stored;
}

inline StoredFile file(std::string name, std::vector<runner::StoredSession> sessions) {
  return {.file = {name, "sha of " + name}, .sessions = std::move(sessions), .warnings = {}};
}

}  // namespace bimodal::analysis::examples
