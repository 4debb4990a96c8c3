#include "analysis/report/proportions.hpp"

#include <array>
#include <cassert>
#include <map>
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
  std::vector<std::string> participants;
  std::size_t words = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> places;  ///< participant, word of each trial
  std::vector<const Score*> scores;                             ///< parallel to places
};

/// Only what occurs is numbered, so that the bootstrap draws from what was there.
Crossing cross(std::span<const Trial> trials,
               std::span<const Score> scores,
               const std::string& condition,
               std::span<const std::string> participants) {
  Crossing crossing;
  std::map<std::string_view, std::uint32_t> words;
  for (const auto& participant : participants) {
    const auto index = static_cast<std::uint32_t>(crossing.participants.size());
    bool took_part = false;
    for (std::size_t i = 0; i < trials.size(); ++i) {
      if (trials[i].participant != participant || trials[i].condition != condition) continue;
      const auto word = words.try_emplace(trials[i].word, static_cast<std::uint32_t>(words.size()));
      crossing.places.emplace_back(index, word.first->second);
      crossing.scores.push_back(&scores[i]);
      took_part = true;
    }
    if (took_part) crossing.participants.push_back(participant);
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
  sum.participants = static_cast<std::int64_t>(crossing.participants.size());
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

std::vector<Proportion> measure_all(const Crossing& crossing, CrossedBootstrap::Options options) {
  const CrossedBootstrap bootstrap{crossing.participants.size(), crossing.words, options};
  std::vector<Proportion> proportions;
  for (const Measure measure : kMeasures) {
    const auto cells = cells_of(crossing, measure);
    auto sum = sum_up(cells, crossing, measure);
    estimate(sum, cells, bootstrap, options.draws);
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
  const auto pooled = cross(trials, scores, condition, participants);
  auto proportions = measure_all(pooled, options);
  for (const auto& participant : pooled.participants) {
    const auto own = cross(trials, scores, condition, {&participant, 1});
    for (auto& proportion : measure_all(own, options)) {
      proportion.participant = participant;
      proportions.push_back(std::move(proportion));
    }
  }
  for (auto& proportion : proportions) proportion.condition = condition;
  return proportions;
}

}  // namespace bimodal::analysis
