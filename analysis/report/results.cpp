#include "analysis/report/results.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/data/gathering.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::analysis {

namespace {

std::string meaning(const Trial& trial) {
  std::string text;
  if (trial.auditory_talker) text += "heard " + *trial.auditory_talker;
  if (trial.snr_db) {
    const std::string_view minus = *trial.snr_db < 0.0 ? "\u2212" : "";
    text += fmt::format(" at {}{} dB S/N", minus, std::abs(*trial.snr_db));
  }
  if (trial.visual_talker) {
    text += fmt::format("{}seen {}", text.empty() ? "" : "; ", *trial.visual_talker);
  }
  return text;
}

/// Heard alone, seen alone, both; then the lesser S/N, then the name.
auto rank(const Trial& trial) {
  const int modality = !trial.visual_talker ? 0 : !trial.auditory_talker ? 1 : 2;
  return std::tuple{modality, trial.snr_db, trial.condition};
}

std::vector<const Trial*> first_of_each_condition(std::span<const Trial> trials) {
  std::map<std::string_view, const Trial*> firsts;
  for (const auto& trial : trials) firsts.try_emplace(trial.condition, &trial);
  std::vector<const Trial*> sorted;
  for (const auto& [name, trial] : firsts) sorted.push_back(trial);
  std::ranges::sort(sorted, {}, [](const Trial* trial) { return rank(*trial); });
  return sorted;
}

std::vector<ConditionSummary> summarise_conditions(std::span<const Trial> trials,
                                                   std::span<const Score> scores) {
  std::vector<ConditionSummary> conditions;
  for (const Trial* const first : first_of_each_condition(trials)) {
    ConditionSummary summary;
    summary.name = first->condition;
    summary.meaning = meaning(*first);
    std::set<std::string_view> participants;
    std::set<std::string_view> words;
    std::array<std::int64_t, kVerdictCount> verdicts{};
    for (std::size_t i = 0; i < trials.size(); ++i) {
      if (trials[i].condition != summary.name) continue;
      participants.insert(trials[i].participant);
      words.insert(trials[i].word);
      ++verdicts.at(static_cast<std::size_t>(scores[i].verdict));
      ++summary.trials;
    }
    summary.participants = static_cast<std::int64_t>(participants.size());
    summary.words = static_cast<std::int64_t>(words.size());
    std::tie(summary.correct,
             summary.homophones,
             summary.tolerated,
             summary.wrong,
             summary.unknown,
             summary.omissions) = std::tuple_cat(verdicts);
    conditions.push_back(std::move(summary));
  }
  return conditions;
}

std::vector<std::string> order_participants(const Dataset& dataset) {
  std::set<std::pair<int, std::string>> numbered;
  for (const auto& session : dataset.sessions) {
    if (session.analysed_trials > 0) {
      numbered.emplace(session.participant_number, session.participant);
    }
  }
  std::vector<std::string> ordered;
  for (const auto& [number, participant] : numbered) {
    if (std::ranges::find(ordered, participant) == ordered.end()) ordered.push_back(participant);
  }
  return ordered;
}

/// Leaves out the participants who do not reach a criterion; counts their trials.
void exclude_below(const Criterion& criterion, Results& results) {
  auto& dataset = results.dataset;

  struct Tally {
    std::int64_t correct = 0;
    std::int64_t trials = 0;
  };

  std::map<std::string, Tally> tallies;
  for (std::size_t i = 0; i < dataset.trials.size(); ++i) {
    const auto& trial = dataset.trials[i];
    if (trial.condition != criterion.condition) continue;
    auto& tally = tallies[trial.participant];
    ++tally.trials;
    tally.correct += results.scores[i].word_correct() ? 1 : 0;
  }
  if (tallies.empty() && !dataset.trials.empty()) {
    std::set<std::string> known;
    for (const auto& trial : dataset.trials) known.insert(trial.condition);
    throw Error{fmt::format("leaving out participants: the data have no condition \"{}\"; {}",
                            criterion.condition,
                            names_there(known))};
  }
  std::set<std::string> below;
  for (const auto& [participant, tally] : tallies) {
    const auto correct = static_cast<double>(tally.correct);
    if (correct < criterion.least * static_cast<double>(tally.trials)) below.insert(participant);
  }
  const auto all = dataset.trials.size();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all; ++i) {
    auto& trial = dataset.trials[i];
    if (below.contains(trial.participant)) {
      --dataset.sessions[trial.session].analysed_trials;
      continue;
    }
    if (kept < i) {
      dataset.trials[kept] = std::move(trial);
      results.scores[kept] = std::move(results.scores[i]);
    }
    ++kept;
  }
  dataset.trials.erase(dataset.trials.begin() + static_cast<std::ptrdiff_t>(kept),
                       dataset.trials.end());
  results.scores.resize(kept);
  dataset.exclusions.push_back(
      {.reason = fmt::format("participant below {:g} correct in \"{}\" ({})",
                             criterion.least,
                             criterion.condition,
                             below.empty() ? "nobody" : fmt::format("{}", fmt::join(below, ", "))),
       .trials = static_cast<std::int64_t>(all - kept)});
}

/// Below this number of participants a resampled interval hardly knows how participants differ.
constexpr std::int64_t kFewParticipants = 6;

void warn(Results& results) {
  results.warnings = results.dataset.warnings;
  if (results.dataset.trials.empty()) {
    results.warnings.emplace_back("There is no trial to analyse.");
  }
  if (results.rules != ScoringRules{}) {
    results.warnings.push_back("Answers are scored by rules of choice. " +
                               describe_rules(results.rules));
  }
  for (const auto& condition : results.conditions) {
    if (condition.participants == 1) {
      results.warnings.push_back(fmt::format(
          "Condition \"{}\" has one participant: its intervals tell nothing about other "
          "participants.",
          condition.name));
    } else if (condition.participants < kFewParticipants) {
      results.warnings.push_back(
          fmt::format("Condition \"{}\" has only {} participants: its pooled intervals are rough, "
                      "and rather too narrow.",
                      condition.name,
                      condition.participants));
    }
    if (condition.unknown * 20 > condition.trials) {
      results.warnings.push_back(fmt::format(
          "Condition \"{}\": {} of {} answers are not in the dictionary; they are wrong "
          "as words and left out of phoneme scores.",
          condition.name,
          condition.unknown,
          condition.trials));
    }
  }
}

}  // namespace

Results analyse(Dataset dataset,
                const Dictionary& dictionary,
                DictionarySource source,
                const AnalysisOptions& options) {
  Results results;
  results.dataset = std::move(dataset);
  results.dictionary = std::move(source);
  results.rules = options.rules;
  results.bootstrap = options.bootstrap;
  results.faces = options.faces;
  results.comparison = options.comparison;
  const auto& trials = results.dataset.trials;
  options.progress(fmt::format("scoring {} answers", trials.size()));
  results.scores = score_all(trials, dictionary, options.rules);
  for (const auto& criterion : options.criteria) exclude_below(criterion, results);
  results.participants = order_participants(results.dataset);
  results.conditions = summarise_conditions(trials, results.scores);
  std::vector<std::string> names;
  for (const auto& condition : results.conditions) names.push_back(condition.name);
  for (const auto& condition : names) {
    options.progress(fmt::format("condition {}: intervals", condition));
    for (auto& proportion : measure_condition(
             trials, results.scores, condition, results.participants, options.bootstrap)) {
      auto& kind = proportion.participant.empty() ? results.pooled : results.individual;
      kind.push_back(std::move(proportion));
    }
  }
  options.progress("confusions");
  results.confusions = tabulate_confusions(trials, results.scores, names);
  results.likeness = compare_conditions(results.confusions);
  results.benefits = tabulate_benefits(results);
  results.shares = tabulate_shares(results);
  results.features = tabulate_features(results.confusions);
  if (results.faces && !results.dataset.trials.empty()) {
    options.progress("comparing the two faces");
    results.comparisons = compare_faces(
        results, results.faces->natural, results.faces->synthetic, options.comparison);
  }
  warn(results);
  return results;
}

}  // namespace bimodal::analysis
