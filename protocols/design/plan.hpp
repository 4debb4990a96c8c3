#pragma once

#include <string>
#include <vector>

#include "protocols/model/protocol.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal::protocols {

enum class Phase { Practice, Main };

/// One trial of one participant, decided before the session begins.
struct PlannedTrial {
  std::size_t index = 0;  ///< from 0, in order of presentation, practice included
  Phase phase = Phase::Main;
  /// From 0; a new block begins after every break. Practice is block 0, and the first main block
  /// then 1; without practice the first main block is 0.
  int block = 0;
  Word word;                  ///< as presented: where nothing is heard, the one that is seen
  std::size_t condition = 0;  ///< index into Protocol::conditions
  Seed noise_seed = 0;
};

/// Who takes part, and for which time. Together with the protocol's seed this decides everything
/// that is random in a session, on every machine.
struct SessionKey {
  int participant_number = 1;  ///< from 1
  int session_number = 1;      ///< from 1; above 1 only with Assignment::EveryCondition
};

/// Every trial of one session, in order. `practice` are the protocol's practice words with their
/// pronunciations. Once: the words are dealt (by the protocol's seed) into as many lists as there
/// are conditions, sizes differing by at most one, and list l meets condition
/// (l + participant) mod C. EveryCondition: list l meets condition (l + participant + session) mod
/// C, so that over C sessions each word meets each condition once. Orders are drawn anew for every
/// participant and session: simple random orders, in which a condition may follow itself. Throws
/// Error for a session number that the assignment does not have, and where there is no condition.
[[nodiscard]] std::vector<PlannedTrial> make_plan(const Protocol& protocol,
                                                  const WordList& words,
                                                  const std::vector<Word>& practice,
                                                  SessionKey key);

}  // namespace bimodal::protocols
