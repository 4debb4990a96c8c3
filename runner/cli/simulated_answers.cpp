#include "runner/cli/simulated_answers.hpp"

#include <memory>
#include <utility>

#include "protocols/observers/observer.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/diagnostic.hpp"
#include "stimuli/base/error.hpp"

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

}  // namespace

Answers simulated_answers(const protocols::Protocol& protocol,
                          const protocols::SessionKey& key,
                          Seed seed) {
  auto observer = std::make_shared<const protocols::Observer>(typical_observer());
  auto random =
      std::make_shared<Random>(derive_seed(seed,
                                           "simulated answers",
                                           {static_cast<std::uint64_t>(key.participant_number),
                                            static_cast<std::uint64_t>(key.session_number)}));
  return [&protocol, observer, random](const protocols::PlannedTrial& trial) {
    const auto& condition = protocol.conditions.at(trial.condition);
    const protocols::Presented presented{.heard = condition.auditory_talker.has_value(),
                                         .seen = condition.visual_talker.has_value(),
                                         .snr = condition.snr};
    return observer->answer(trial.word, presented, *random).spelling;
  };
}

std::string observer_name() {
  return "typical";
}

}  // namespace bimodal::runner
