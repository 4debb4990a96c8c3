#include "runner/cli/simulated_answers.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "protocols/observers/closed_set.hpp"
#include "protocols/observers/observer.hpp"
#include "runner/booth/answering.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/diagnostic.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/lower_case.hpp"
#include "stimuli/words/letter_to_sound.hpp"

namespace bimodal::runner {

namespace {

constexpr const char* kObserver = "protocols/observers/typical.json";
constexpr const char* kCandidates = "stimuli/assets/words/familiar-monosyllables.json";

protocols::Observer typical_observer() {
  std::vector<Diagnostic> diagnostics;
  auto description = protocols::read_observer(asset(kObserver), diagnostics);
  const auto candidates = read_word_list(asset(kCandidates), diagnostics);
  if (has_errors(diagnostics)) throw Error{describe(diagnostics.front())};
  return {std::move(description), candidates.words};
}

protocols::Presented presented_in(const protocols::Condition& condition) {
  return {.heard = condition.auditory_talker.has_value(),
          .seen = condition.visual_talker.has_value(),
          .snr = condition.snr};
}

/// How each label is said; no phones where it is no word.
std::vector<Pronunciation> said_labels(const protocols::ReadProtocol& read) {
  const auto rules = LetterToSound::shipped();
  std::vector<Pronunciation> said;
  for (const auto& option : read.protocol.response.options) {
    const auto spelling = lower_case(option.label);
    const auto& words = read.words.words;
    const auto known = std::ranges::find(words, spelling, &Word::spelling);
    if (known != words.end()) {
      said.push_back(known->phones);
      continue;
    }
    const auto by_rule = rules.words(option.label);
    said.push_back(by_rule.size() == 1 ? by_rule.front().phones : Pronunciation{});
  }
  return said;
}

}  // namespace

Answers simulated_answers(const protocols::ReadProtocol& read,
                          const protocols::SessionKey& key,
                          Seed seed) {
  auto observer = std::make_shared<const protocols::Observer>(typical_observer());
  auto random =
      std::make_shared<Random>(derive_seed(seed,
                                           "simulated answers",
                                           {static_cast<std::uint64_t>(key.participant_number),
                                            static_cast<std::uint64_t>(key.session_number)}));
  const auto& protocol = read.protocol;
  if (protocol.response.kind == protocols::ResponseKind::Typed) {
    return [&protocol, observer, random](const protocols::PlannedTrial& trial) {
      const auto presented = presented_in(protocol.conditions.at(trial.condition));
      return observer->answer(trial.word, presented, *random).spelling;
    };
  }
  return [&protocol, observer, random, said = said_labels(read)](
             const protocols::PlannedTrial& trial) {
    const auto presented = presented_in(protocol.conditions.at(trial.condition));
    const auto table = protocols::confusions(observer->description(), presented);
    const auto chosen =
        random->weighted(protocols::closed_set_probabilities(trial.word.phones, said, table));
    return protocol.response.options.at(chosen).label;
  };
}

SimulatedKeyboard::Options simulated_typist(const protocols::Protocol& protocol) {
  SimulatedKeyboard::Options options;
  const auto rules = trial_rules(protocol, question_of(protocol));
  if (!rules.choice) return options;
  for (std::size_t i = 0; i < rules.choice->options.size(); ++i) {
    options.choices.emplace(rules.choice->options[i].label, stroke_for(*rules.choice, i));
  }
  options.confirms_choice = rules.choice->confirm;
  return options;
}

std::string observer_name() {
  return "typical";
}

}  // namespace bimodal::runner
