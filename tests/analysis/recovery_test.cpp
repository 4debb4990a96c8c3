// The whole way from a listener's confusions to the report's matrices: simulated listeners answer
// the 414 words, the answers are scored and tabulated as for a report, and the matrices must be
// those that follow from the listener's stated confusion probabilities, by enumeration over the
// dictionary.

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/report/confusions.hpp"
#include "protocols/observers/observer.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/words/dictionary.hpp"

namespace bimodal::analysis {
namespace {

constexpr int kAnswersPerWord = 40;

using Partners = std::vector<std::optional<Phone>>;  // of each stimulus phone

/// Every way to lay one word along another, by plain recursion.
class AllAlignments {
 public:
  AllAlignments(const Pronunciation& stimulus, const Pronunciation& answer)
      : stimulus_{stimulus}, answer_{answer}, partners_(stimulus.size()) {
    extend(0, 0, 0, 0);
  }

  /// The partner of a stimulus phone if all best alignments agree on it; else nothing.
  [[nodiscard]] std::optional<std::optional<Phone>> partner(std::size_t place) const {
    std::set<std::optional<Phone>> seen;
    for (const auto& partners : best_) seen.insert(partners.at(place));
    if (seen.size() != 1) return std::nullopt;
    return *seen.begin();
  }

 private:
  void extend(std::size_t i, std::size_t j, int cost, int matches) {
    if (cost > cost_) return;
    if (i == stimulus_.size() && j == answer_.size()) {
      if (cost < cost_ || matches > matches_) best_.clear();
      if (cost == cost_ && matches < matches_) return;
      cost_ = cost;
      matches_ = matches;
      best_.push_back(partners_);
      return;
    }
    if (i < stimulus_.size()) {
      partners_[i] = std::nullopt;
      extend(i + 1, j, cost + 1, matches);
    }
    if (j < answer_.size()) extend(i, j + 1, cost + 1, matches);
    if (i < stimulus_.size() && j < answer_.size() &&
        is_vowel(stimulus_[i]) == is_vowel(answer_[j])) {
      const bool same = stimulus_[i] == answer_[j];
      partners_[i] = answer_[j];
      extend(i + 1, j + 1, cost + (same ? 0 : 1), matches + (same ? 1 : 0));
    }
  }

  const Pronunciation& stimulus_;
  const Pronunciation& answer_;
  Partners partners_;
  int cost_ = 1'000;
  int matches_ = -1;
  std::vector<Partners> best_;
};

std::optional<std::size_t> place(Unit unit, const Pronunciation& phones) {
  switch (unit) {
    case Unit::ConsonantInitial:
      return is_vowel(phones.front()) ? std::nullopt : std::optional<std::size_t>{0};
    case Unit::ConsonantFinal:
      return is_vowel(phones.back()) ? std::nullopt : std::optional{phones.size() - 1};
    case Unit::Vowel:
      for (std::size_t i = 0; i < phones.size(); ++i) {
        if (is_vowel(phones[i])) return i;
      }
  }
  return std::nullopt;
}

struct Expected {
  double count = 0.0;
  double variance = 0.0;
};

using Cell = std::pair<std::string, std::string>;
using Table = std::map<Cell, Expected>;

struct Laboratory {
  Laboratory()
      : words{read_word_list(asset("stimuli/assets/words/monosyllables-414.json"), diagnostics)},
        candidates{
            read_word_list(asset("stimuli/assets/words/familiar-monosyllables.json"), diagnostics)},
        observer{protocols::read_observer(asset("protocols/observers/typical.json"), diagnostics),
                 candidates.words},
        dictionary{Dictionary::installed()} {}

  std::vector<Diagnostic> diagnostics;
  WordList words;
  WordList candidates;
  protocols::Observer observer;
  Dictionary dictionary;
};

std::array<Table, 3> expectation(const Laboratory& laboratory,
                                 const protocols::Presented& presented) {
  std::array<Table, 3> tables;
  for (const auto& word : laboratory.words.words) {
    std::array<std::map<std::string, double>, 3> chances;
    for (const auto& answer : laboratory.observer.answers(word, presented)) {
      const AllAlignments alignments{word.phones, answer.word.phones};
      for (std::size_t unit = 0; unit < kUnits.size(); ++unit) {
        const auto at = place(kUnits.at(unit), word.phones);
        const auto partner = at ? alignments.partner(*at) : std::nullopt;
        if (!partner) continue;
        chances.at(unit)[*partner ? std::string{symbol(**partner)} : std::string{kDeleted}] +=
            answer.probability;
      }
    }
    for (std::size_t unit = 0; unit < kUnits.size(); ++unit) {
      for (const auto& [response, chance] : chances.at(unit)) {
        const auto at = place(kUnits.at(unit), word.phones);
        auto& cell = tables.at(unit)[{std::string{symbol(word.phones.at(*at))}, response}];
        cell.count += kAnswersPerWord * chance;
        cell.variance += kAnswersPerWord * chance * (1.0 - chance);
      }
    }
  }
  return tables;
}

std::vector<UnitConfusions> observation(const Laboratory& laboratory,
                                        const protocols::Presented& presented,
                                        Seed seed) {
  Random random{seed};
  std::vector<Trial> trials;
  for (const auto& word : laboratory.words.words) {
    for (int i = 0; i < kAnswersPerWord; ++i) {
      trials.push_back({.participant = "S01",
                        .phase = "main",
                        .condition = "all",
                        .word = word.spelling,
                        .phones = word.phones,
                        .response = laboratory.observer.answer(word, presented, random).spelling});
    }
  }
  const std::vector<std::string> conditions{"all"};
  return tabulate_confusions(trials, score_all(trials, laboratory.dictionary), conditions);
}

/// Every cell within five standard errors (and one count, for cells that are hardly ever met), and
/// the mean squared standardized deviation of the well-filled cells near 1.
void compare(const Table& expected, const ConfusionMatrix& matrix) {
  double squares = 0.0;
  int filled = 0;
  for (std::size_t row = 0; row < matrix.stimuli().size(); ++row) {
    for (std::size_t column = 0; column < matrix.responses().size(); ++column) {
      const Cell cell{matrix.stimuli().at(row), matrix.responses().at(column)};
      const auto found = expected.find(cell);
      const auto [count, variance] = found == expected.end() ? Expected{} : found->second;
      const double deviation = static_cast<double>(matrix.count(row, column)) - count;
      ASSERT_LE(std::abs(deviation), 5.0 * std::sqrt(variance) + 1.0)
          << cell.first << " answered " << cell.second;
      if (variance < 5.0) continue;
      squares += deviation * deviation / variance;
      ++filled;
    }
  }
  ASSERT_GT(filled, 30);
  // Four standard errors of a mean of squared normal deviates.
  EXPECT_NEAR(squares / filled, 1.0, 4.0 * std::sqrt(2.0 / filled));
}

class Recovery : public testing::TestWithParam<protocols::Presented> {};

TEST_P(Recovery, FindsTheConfusionsThatTheListenersHave) {
  try {
    static_cast<void>(Dictionary::installed());
  } catch (const std::exception& error) {
    GTEST_SKIP() << error.what();
  }
  const Laboratory laboratory;
  ASSERT_FALSE(has_errors(laboratory.diagnostics));
  const auto expected = expectation(laboratory, GetParam());
  const auto observed = observation(laboratory, GetParam(), 20'261'122);
  ASSERT_EQ(observed.size(), kUnits.size());
  for (std::size_t unit = 0; unit < kUnits.size(); ++unit) {
    SCOPED_TRACE(std::string{name(kUnits.at(unit))});
    compare(expected.at(unit), observed.at(unit).matrix);
  }
}

INSTANTIATE_TEST_SUITE_P(ByEarByEyeAndByBoth,
                         Recovery,
                         testing::Values(protocols::Presented{.heard = true, .snr = Decibels{-8.0}},
                                         protocols::Presented{.seen = true},
                                         protocols::Presented{
                                             .heard = true, .seen = true, .snr = Decibels{-8.0}}));

}  // namespace
}  // namespace bimodal::analysis
