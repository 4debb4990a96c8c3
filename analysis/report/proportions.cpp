#include "analysis/report/proportions.hpp"

#include <array>
#include <cassert>
#include <map>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

namespace bimodal::analysis {

namespace {

constexpr std::array<std::string_view, kMeasures.size()> kNames{
    "word", "phoneme", "consonant-initial", "vowel", "consonant-final"};

struct Tally {
  std::uint32_t correct = 0;
  std::uint32_t judged = 0;
};

Tally tally_unit(const Score& score, Unit unit) {
  const auto& found = score.units.at(static_cast<std::size_t>(unit));
  if (!found || found->outcome == UnitScore::Outcome::Ambiguous) return {};
  const bool correct =
      found->outcome == UnitScore::Outcome::Answered && found->answer == found->stimulus;
  return {correct ? 1U : 0U, 1U};
}

Tally tally(const Score& score, Measure measure) {
  switch (measure) {
    case Measure::Word:
      return {score.word_correct() ? 1U : 0U, 1U};
    case Measure::Phoneme:
      if (!score.phones_correct) return {};
      return {static_cast<std::uint32_t>(*score.phones_correct),
              static_cast<std::uint32_t>(score.phones)};
    case Measure::ConsonantInitial:
      return tally_unit(score, Unit::ConsonantInitial);
    case Measure::Vowel:
      return tally_unit(score, Unit::Vowel);
    case Measure::ConsonantFinal:
      return tally_unit(score, Unit::ConsonantFinal);
  }
  return {};
}

/// Trials of one condition as participants crossed with words.
struct Crossing {
  std::size_t participants = 0;
  std::size_t words = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> places;  ///< participant, word of each trial
  std::vector<const Score*> scores;                             ///< parallel to places
};

/// The trials of one participant in one condition.
struct OwnTrials {
  std::string participant;
  std::vector<std::size_t> indices;
};

/// In the order of `participants`; those without a trial are left out.
std::vector<OwnTrials> sort_by_participant(std::span<const Trial> trials,
                                           const std::string& condition,
                                           std::span<const std::string> participants) {
  std::map<std::string_view, std::vector<std::size_t>> indices;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (trials[i].condition == condition) indices[trials[i].participant].push_back(i);
  }
  std::vector<OwnTrials> sorted;
  for (const auto& participant : participants) {
    const auto found = indices.find(participant);
    if (found != indices.end()) sorted.push_back({participant, found->second});
  }
  return sorted;
}

/// Only words that occur are numbered, so that the bootstrap draws from what was there.
Crossing cross(std::span<const Trial> trials,
               std::span<const Score> scores,
               std::span<const OwnTrials> participants) {
  Crossing crossing;
  crossing.participants = participants.size();
  std::unordered_map<std::string_view, std::uint32_t> words;
  for (std::uint32_t p = 0; p < participants.size(); ++p) {
    for (const auto i : participants[p].indices) {
      const auto next = static_cast<std::uint32_t>(words.size());
      const auto word = words.try_emplace(trials[i].word, next).first->second;
      crossing.places.emplace_back(p, word);
      crossing.scores.push_back(&scores[i]);
    }
  }
  crossing.words = words.size();
  return crossing;
}

std::vector<CrossedCell> cells_of(const Crossing& crossing, Measure measure) {
  std::vector<CrossedCell> cells;
  for (std::size_t i = 0; i < crossing.places.size(); ++i) {
    const auto [correct, judged] = tally(*crossing.scores[i], measure);
    if (judged == 0) continue;
    cells.push_back({.participant = crossing.places[i].first,
                     .word = crossing.places[i].second,
                     .successes = correct,
                     .trials = judged});
  }
  return cells;
}

Proportion sum_up(std::span<const CrossedCell> cells, const Crossing& crossing, Measure measure) {
  Proportion sum;
  sum.measure = measure;
  sum.participants = static_cast<std::int64_t>(crossing.participants);
  sum.words = static_cast<std::int64_t>(crossing.words);
  for (const auto& cell : cells) {
    sum.correct += cell.successes;
    sum.judged += cell.trials;
  }
  if (sum.judged > 0) {
    sum.proportion = static_cast<double>(sum.correct) / static_cast<double>(sum.judged);
  }
  return sum;
}

void estimate(Proportion& sum,
              std::span<const CrossedCell> cells,
              const CrossedBootstrap& bootstrap,
              int draws) {
  if (sum.judged == 0) {
    sum.method = "no interval: nothing to judge";
    return;
  }
  if (sum.participants == 1 && sum.measure != Measure::Phoneme) {
    sum.interval = wilson(sum.correct, sum.judged);
    sum.method = "Wilson";
    return;
  }
  sum.interval = bootstrap.interval(cells);
  if (!sum.interval) {
    sum.method = sum.correct == 0 || sum.correct == sum.judged
                     ? "no interval: without any variation resampling says nothing"
                     : "no interval: too few trials to resample";
  } else if (sum.participants == 1) {
    sum.method = fmt::format("bootstrap over {} words, {} draws", sum.words, draws);
  } else {
    sum.method = fmt::format("crossed bootstrap, {} participants x {} words, {} draws",
                             sum.participants,
                             sum.words,
                             draws);
  }
}

/// Makes each resampling plan once: drawing it costs more than using it, and one of the same size
/// serves every participant.
class Bootstraps {
 public:
  explicit Bootstraps(CrossedBootstrap::Options options) : options_{options} {}

  const CrossedBootstrap& of(const Crossing& crossing) {
    const auto size = std::pair{crossing.participants, crossing.words};
    return made_.try_emplace(size, size.first, size.second, options_).first->second;
  }

 private:
  CrossedBootstrap::Options options_;
  std::map<std::pair<std::size_t, std::size_t>, CrossedBootstrap> made_;
};

std::vector<Proportion> measure_all(const Crossing& crossing,
                                    const CrossedBootstrap& bootstrap,
                                    int draws) {
  std::vector<Proportion> proportions;
  for (const Measure measure : kMeasures) {
    const auto cells = cells_of(crossing, measure);
    auto sum = sum_up(cells, crossing, measure);
    estimate(sum, cells, bootstrap, draws);
    proportions.push_back(std::move(sum));
  }
  return proportions;
}

}  // namespace

std::string_view name(Measure measure) {
  return kNames.at(static_cast<std::size_t>(measure));
}

std::vector<Proportion> measure_condition(std::span<const Trial> trials,
                                          std::span<const Score> scores,
                                          const std::string& condition,
                                          std::span<const std::string> participants,
                                          CrossedBootstrap::Options options) {
  assert(trials.size() == scores.size());
  const auto sorted = sort_by_participant(trials, condition, participants);
  const auto pooled = cross(trials, scores, sorted);
  Bootstraps bootstraps{options};
  auto proportions = measure_all(pooled, bootstraps.of(pooled), options.draws);
  for (const auto& own_trials : sorted) {
    const auto own = cross(trials, scores, {&own_trials, 1});
    for (auto& proportion : measure_all(own, bootstraps.of(own), options.draws)) {
      proportion.participant = own_trials.participant;
      proportions.push_back(std::move(proportion));
    }
  }
  for (auto& proportion : proportions) proportion.condition = condition;
  return proportions;
}

}  // namespace bimodal::analysis
