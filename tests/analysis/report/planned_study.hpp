#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/report/results.hpp"
#include "tests/analysis/examples.hpp"

namespace bimodal::analysis::examples {

inline constexpr int kParticipants = 6;
inline constexpr int kWords = 12;

/// A condition whose answers are right or blank by arithmetic.
struct PlannedCondition {
  std::string name;
  std::optional<std::string> heard;
  std::optional<std::string> seen;
  std::function<bool(int participant, int word)> is_right;
};

inline std::vector<PlannedCondition> five_conditions() {
  const std::string voice = "corpus:one";
  const auto heard = [](int p, int w) { return (3 * p + 5 * w) % 7 < 3; };
  return {
      {"A", voice, std::nullopt, heard},
      {"AV natural", voice, "corpus:one", [](int p, int w) { return (p * w + p + 2 * w) % 5 < 4; }},
      {"AV synthetic", voice, "face", [](int p, int w) { return (3 * p + 5 * w) % 7 < 4; }},
      {"V natural", std::nullopt, "corpus:one", [](int p, int w) { return (p + w) % 6 < 1; }},
      {"AV static", voice, "picture", heard}};
}

/// Every participant met all words of the dictionary's first in all conditions.
inline Results results_of(const std::vector<PlannedCondition>& conditions,
                          int participants = kParticipants,
                          const AnalysisOptions& options = {
                              .bootstrap = {.draws = 20'000, .seed = 4}}) {
  const std::vector<std::pair<std::string, std::string>> words{{"bat", "B AE T"},
                                                               {"bed", "B EH D"},
                                                               {"bee", "B IY"},
                                                               {"blow", "B L OW"},
                                                               {"eight", "EY T"},
                                                               {"mat", "M AE T"},
                                                               {"pat", "P AE T"},
                                                               {"reed", "R IY D"},
                                                               {"rid", "R IH D"},
                                                               {"stew", "S T UW"},
                                                               {"two", "T UW"},
                                                               {"well", "W EH L"}};
  std::vector<runner::StoredSession> sessions;
  for (int p = 0; p < participants; ++p) {
    std::vector<runner::StoredTrial> trials;
    for (const auto& condition : conditions) {
      for (int w = 0; w < kWords; ++w) {
        const auto& [word, spoken] = words.at(static_cast<std::size_t>(w));
        auto trial = stored_trial(
            static_cast<int>(trials.size()), word, spoken, condition.is_right(p, w) ? word : "");
        trial.plan.condition = condition.name;
        trial.plan.auditory_talker = condition.heard;
        trial.plan.visual_talker = condition.seen;
        if (!condition.heard) trial.plan.snr_db.reset();
        trials.push_back(std::move(trial));
      }
    }
    sessions.push_back(session("P" + std::to_string(p), std::move(trials)));
    sessions.back().session.participant_number = p + 1;
  }
  const WrittenFiles folder;
  const std::vector files{file("a.sqlite", sessions)};
  return analyse(gather_trials(files), dictionary(folder), {.file = "d", .sha256 = "0"}, options);
}

}  // namespace bimodal::analysis::examples
