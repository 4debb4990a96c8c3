#include "analysis/data/cautions.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bimodal::analysis {

namespace {

std::string counted(std::int64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

void caution_unfinished(Dataset& dataset) {
  for (const auto& session : dataset.sessions) {
    if (session.outcome == "complete" || session.analysed_trials == 0) continue;
    dataset.warnings.push_back(
        fmt::format("Session {} of participant {} was {}: {} of {} planned trials took place; they "
                    "are included.",
                    session.session_number,
                    session.participant,
                    session.outcome,
                    session.stored_trials,
                    session.planned_trials));
  }
}

void caution_shortened(Dataset& dataset) {
  const auto shortened = std::ranges::count_if(dataset.sessions, [](const SessionSummary& session) {
    return session.shortened && session.analysed_trials > 0;
  });
  if (shortened == 0) return;
  dataset.warnings.push_back(
      fmt::format("{} shortened for trying out (--trials or --no-practice); included.",
                  counted(shortened, "session was", "sessions were")));
}

void caution_mixtures(Dataset& dataset) {
  std::set<std::string> protocols;
  std::set<std::string> people;
  std::set<std::string> simulations;
  for (const auto& session : dataset.sessions) {
    if (session.analysed_trials == 0) continue;
    protocols.insert(session.protocol_sha256);
    (session.simulated ? simulations : people).insert(session.participant);
  }
  if (protocols.size() > 1) {
    dataset.warnings.push_back(fmt::format(
        "The sessions ran {} different protocols; conditions are put together by their names.",
        protocols.size()));
  }
  if (people.empty() || simulations.empty()) return;
  dataset.warnings.push_back(
      "Sessions of people and simulated sessions are put together in every number below.");
  std::vector<std::string> both;
  std::ranges::set_intersection(people, simulations, std::back_inserter(both));
  if (both.empty()) return;
  dataset.warnings.push_back(
      fmt::format("A person and a simulation share a participant's name and are counted as one "
                  "participant: {}.",
                  fmt::join(both, ", ")));
}

void caution_ambiguous_conditions(Dataset& dataset) {
  using Meaning =
      std::tuple<std::optional<std::string>, std::optional<std::string>, std::optional<double>>;
  std::map<std::string, std::set<Meaning>> meanings;
  for (const auto& trial : dataset.trials) {
    meanings[trial.condition].emplace(trial.auditory_talker, trial.visual_talker, trial.snr_db);
  }
  for (const auto& [condition, found] : meanings) {
    if (found.size() < 2) continue;
    dataset.warnings.push_back(fmt::format(
        "Condition \"{}\" has {} different meanings (talkers or S/N) in these data; they "
        "are counted as one condition.",
        condition,
        found.size()));
  }
}

void caution_faces(Dataset& dataset) {
  std::map<std::string, std::set<std::string>> faces;
  for (const auto& trial : dataset.trials) {
    if (trial.face) faces[trial.condition].insert(*trial.face);
  }
  for (const auto& [condition, found] : faces) {
    if (found.size() < 2) continue;
    dataset.warnings.push_back(fmt::format(
        "The synthetic face of condition \"{}\" looked in {} ways in these data (plan.face of the "
        "data files); they are counted as one condition.",
        condition,
        found.size()));
  }
}

void caution_face_qualities(Dataset& dataset) {
  std::int64_t fast = 0;
  std::int64_t full = 0;
  for (const auto& session : dataset.sessions) {
    if (session.analysed_trials == 0) continue;
    if (session.face_quality == "fast") ++fast;
    if (session.face_quality == "full") ++full;
  }
  if (fast == 0 || full == 0) return;
  dataset.warnings.push_back(
      fmt::format("The face was drawn in full quality in {} and in fast in {}: participants may "
                  "differ by it. \"face_quality\" in the protocol draws all alike.",
                  counted(full, "session", "sessions"),
                  fast));
}

void caution_repetitions(Dataset& dataset) {
  std::map<std::tuple<std::string_view, std::string_view, std::string_view>, int> met;
  for (const auto& trial : dataset.trials) ++met[{trial.participant, trial.condition, trial.word}];
  std::int64_t repeated = 0;
  std::set<std::string_view> participants;
  for (const auto& [key, times] : met) {
    if (times < 2) continue;
    repeated += times - 1;
    participants.insert(std::get<0>(key));
  }
  if (repeated == 0) return;
  dataset.warnings.push_back(
      fmt::format("{} a word that the participant had already met in the same condition "
                  "(participants: {}); all are counted.",
                  counted(repeated, "trial repeats", "trials repeat"),
                  fmt::join(participants, ", ")));
}

/// Of lines pasted twice, and of data given in two files.
void caution_copies(Dataset& dataset) {
  const auto place = [&dataset](const Trial* trial) {
    return std::tuple{std::string_view{trial->participant},
                      trial->simulated,
                      dataset.sessions[trial->session].session_number,
                      std::string_view{trial->phase},
                      trial->block,
                      trial->trial,
                      std::string_view{trial->condition},
                      std::string_view{trial->word}};
  };
  std::vector<const Trial*> trials;
  trials.reserve(dataset.trials.size());
  for (const auto& trial : dataset.trials) trials.push_back(&trial);
  std::ranges::sort(trials, {}, place);
  std::int64_t copies = 0;
  std::set<std::string_view> participants;
  for (std::size_t i = 1; i < trials.size(); ++i) {
    if (place(trials[i]) != place(trials[i - 1])) continue;
    ++copies;
    participants.insert(trials[i]->participant);
  }
  if (copies == 0) return;
  dataset.warnings.push_back(fmt::format(
      "{} in the data already, with the same participant, session, phase, block, number, condition "
      "and word (participants: {}), as if pasted or given twice; all are counted.",
      counted(copies, "trial is", "trials are"),
      fmt::join(participants, ", ")));
}

void caution_trials(Dataset& dataset) {
  const auto flagged = std::ranges::count_if(dataset.trials, &Trial::flagged);
  if (flagged > 0) {
    dataset.warnings.push_back(
        fmt::format("{} flagged because the timing was not as planned (late frames, sound "
                    "underflow); included. Leave out with --exclude-flagged.",
                    counted(flagged, "analysed trial is", "analysed trials are")));
  }
  const auto dubbed = std::ranges::count_if(
      dataset.trials, [](const Trial& trial) { return trial.visual_word.has_value(); });
  if (dubbed > 0) {
    dataset.warnings.push_back(
        fmt::format("{} dubbed: another word was seen than heard. Answers are scored by the word "
                    "heard; visual_word in trials.csv is the one seen.",
                    counted(dubbed, "analysed trial is", "analysed trials are")));
  }
  const auto cut = std::ranges::count_if(dataset.trials, [](const Trial& trial) {
    return trial.timed_out && !trial.response.empty();
  });
  if (cut > 0) {
    dataset.warnings.push_back(fmt::format("{} cut off by the time limit; scored as typed so far.",
                                           counted(cut, "answer was", "answers were")));
  }
}

}  // namespace

void add_cautions(Dataset& dataset) {
  caution_mixtures(dataset);
  caution_ambiguous_conditions(dataset);
  caution_faces(dataset);
  caution_face_qualities(dataset);
  caution_unfinished(dataset);
  caution_shortened(dataset);
  caution_copies(dataset);
  caution_repetitions(dataset);
  caution_trials(dataset);
}

}  // namespace bimodal::analysis
