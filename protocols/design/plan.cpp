#include "protocols/design/plan.hpp"

#include <cstdint>
#include <numeric>
#include <span>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal::protocols {

namespace {

void refuse_impossible(const Protocol& protocol, SessionKey key) {
  if (protocol.conditions.empty()) {
    throw Error{fmt::format("cannot plan '{}': it has no condition; add one", protocol.title)};
  }
  const bool once = protocol.assignment == Assignment::Once;
  const std::size_t sessions = once ? 1 : protocol.conditions.size();
  const bool has_session =
      key.session_number >= 1 && static_cast<std::size_t>(key.session_number) <= sessions;
  if (!has_session) {
    throw Error{fmt::format(
        "cannot plan session {} of '{}': with the assignment \"{}\" and {} condition{} there {} {};"
        " give a session number from 1 to {}",
        key.session_number,
        protocol.title,
        once ? "once" : "every-condition",
        protocol.conditions.size(),
        protocol.conditions.size() == 1 ? "" : "s",
        sessions == 1 ? "is only" : "are",
        sessions,
        sessions)};
  }
  if (key.participant_number < 1) {
    throw Error{fmt::format("cannot plan '{}' for participant number {}; numbers begin with 1",
                            protocol.title,
                            key.participant_number)};
  }
}

/// The list that each word is dealt to: the same for every participant and session.
std::vector<std::size_t> deal(std::size_t words, std::size_t lists, Seed seed) {
  std::vector<std::size_t> order(words);
  std::iota(order.begin(), order.end(), std::size_t{0});
  Random random{derive_seed(seed, "lists")};
  shuffle(std::span{order}, random);
  std::vector<std::size_t> list_of(words);
  for (std::size_t place = 0; place < words; ++place) list_of[order[place]] = place % lists;
  return list_of;
}

/// The words, by index, in the order of this session.
std::vector<std::size_t> draw_order(std::size_t words, Seed seed, SessionKey key) {
  std::vector<std::size_t> order(words);
  std::iota(order.begin(), order.end(), std::size_t{0});
  Random random{derive_seed(seed,
                            "order",
                            {static_cast<std::uint64_t>(key.participant_number),
                             static_cast<std::uint64_t>(key.session_number)})};
  shuffle(std::span{order}, random);
  return order;
}

/// The word as it is met in a condition: where nothing is heard the seen one is presented, and
/// where nobody is seen there is no other.
Word presented(const Word& word, const Condition& condition) {
  if (!word.seen) return word;
  if (!condition.auditory_talker) return {word.seen->spelling, word.seen->phones, std::nullopt};
  if (!condition.visual_talker) return {word.spelling, word.phones, std::nullopt};
  return word;
}

}  // namespace

std::vector<PlannedTrial> make_plan(const Protocol& protocol,
                                    const WordList& words,
                                    const std::vector<Word>& practice,
                                    SessionKey key) {
  refuse_impossible(protocol, key);
  const std::size_t conditions = protocol.conditions.size();
  const auto participant = static_cast<std::size_t>(key.participant_number);
  const auto session = static_cast<std::size_t>(key.session_number);
  const std::size_t turn =
      participant + (protocol.assignment == Assignment::EveryCondition ? session : 0);

  std::vector<PlannedTrial> plan;
  plan.reserve(practice.size() + words.words.size());
  const auto add = [&](Phase phase, int block, const Word& word, std::size_t condition) {
    const Seed noise = derive_seed(protocol.seed, "noise", {participant, session, plan.size()});
    const auto& met = protocol.conditions[condition];
    plan.push_back({plan.size(), phase, block, presented(word, met), condition, noise});
  };

  for (const Word& word : practice) add(Phase::Practice, 0, word, plan.size() % conditions);

  const auto list_of = deal(words.words.size(), conditions, protocol.seed);
  const int first_block = practice.empty() ? 0 : 1;
  int presented = 0;
  for (const std::size_t index : draw_order(words.words.size(), protocol.seed, key)) {
    const int every = protocol.breaks.every_trials;
    const int block = first_block + (every > 0 ? presented / every : 0);
    add(Phase::Main, block, words.words[index], (list_of[index] + turn) % conditions);
    ++presented;
  }
  return plan;
}

}  // namespace bimodal::protocols
