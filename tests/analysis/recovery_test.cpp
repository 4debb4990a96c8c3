// From simulated listeners to the report: does the analysis find the confusions that were put in?

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/report/confusions.hpp"
#include "analysis/scoring/score.hpp"
#include "protocols/observers/implied_confusions.hpp"
#include "protocols/observers/observer.hpp"
#include "stimuli/base/asset.hpp"

namespace bimodal::analysis {
namespace {

using protocols::Observer;
using protocols::Presented;

/// "ambiguous", "deleted", "other" or the phone that stands in a unit's place.
using Label = std::string;
/// One for each of kPlaceUnits; empty where the word has no such unit.
using Labels = std::array<Label, kPlaceUnits.size()>;

const std::string kAmbiguous = "ambiguous";

struct Condition {
  std::string name;
  Presented presented;
};

const std::vector<Condition>& conditions() {
  static const std::vector<Condition> all{
      {"auditory", {.heard = true, .seen = false, .snr = Decibels{-8}}},
      {"visual", {.heard = false, .seen = true, .snr = {}}},
      {"bimodal", {.heard = true, .seen = true, .snr = Decibels{-8}}}};
  return all;
}

std::vector<Word> words(const std::string& file) {
  std::vector<Diagnostic> diagnostics;
  auto list = read_word_list(asset("stimuli/assets/words/" + file), diagnostics);
  EXPECT_TRUE(diagnostics.empty());
  return list.words;
}

Observer typical(std::span<const Word> candidates) {
  std::vector<Diagnostic> diagnostics;
  auto description =
      protocols::read_observer(asset("protocols/observers/typical.json"), diagnostics);
  EXPECT_TRUE(diagnostics.empty());
  return {std::move(description), candidates};
}

const Dictionary& installed_dictionary() {
  static const Dictionary dictionary{Dictionary::installed()};
  return dictionary;
}

/// Tries every way to let phones of an answer stand, in order, against phones of a stimulus, and
/// keeps what the best ways say. Nothing is shared with the program's own alignment.
class EveryAlignment {
 public:
  explicit EveryAlignment(const Pronunciation& stimulus)
      : stimulus_{stimulus}, chosen_(stimulus.size()), partners_(stimulus.size()) {}

  void try_answer(const Pronunciation& answer) { extend(answer, 0, 0, 0, 0, 0); }

  [[nodiscard]] Label label(std::size_t place) const {
    if (partners_[place].size() > 1) return kAmbiguous;
    const Phone partner = *partners_[place].begin();
    return partner == Phone::Rest ? "deleted" : std::string{symbol(partner)};
  }

 private:
  void extend(const Pronunciation& answer,
              std::size_t place,
              std::size_t next,
              int against,
              int substitutions,
              int matches) {
    if (place == stimulus_.size()) {
      const int deletions = static_cast<int>(stimulus_.size()) - against;
      const int insertions = static_cast<int>(answer.size()) - against;
      keep_if_best({substitutions + deletions + insertions, -matches});
      return;
    }
    chosen_[place] = Phone::Rest;
    extend(answer, place + 1, next, against, substitutions, matches);
    for (std::size_t j = next; j < answer.size(); ++j) {
      if (is_vowel(answer[j]) != is_vowel(stimulus_[place])) continue;
      const bool match = answer[j] == stimulus_[place];
      chosen_[place] = answer[j];
      extend(answer,
             place + 1,
             j + 1,
             against + 1,
             substitutions + (match ? 0 : 1),
             matches + (match ? 1 : 0));
    }
  }

  void keep_if_best(std::pair<int, int> badness) {
    if (badness > least_) return;
    if (badness < least_) {
      least_ = badness;
      for (auto& partners : partners_) partners.clear();
    }
    for (std::size_t i = 0; i < chosen_.size(); ++i) partners_[i].insert(chosen_[i]);
  }

  const Pronunciation& stimulus_;
  std::vector<Phone> chosen_;
  std::vector<std::set<Phone>> partners_;  ///< Rest: nothing
  std::pair<int, int> least_{1000, 0};
};

/// What the report must make of an answer, by the written rules.
Labels expected_labels(const Word& stimulus, const Word& answer) {
  const auto& phones = stimulus.phones;
  const auto said = installed_dictionary().pronunciations(answer.spelling);
  const auto meant = installed_dictionary().pronunciations(stimulus.spelling);
  const bool correct =
      answer.spelling == stimulus.spelling || std::ranges::any_of(said, [&](const auto& one) {
        return one == phones || std::ranges::find(meant, one) != meant.end();
      });
  EveryAlignment alignments{phones};
  for (const auto& one : said) alignments.try_answer(one);
  const auto label = [&](std::size_t place) -> Label {
    if (correct) return std::string{symbol(phones[place])};
    return said.empty() ? "other" : alignments.label(place);
  };
  Labels labels;
  if (is_consonant(phones.front())) labels[0] = label(0);
  labels[1] =
      label(static_cast<std::size_t>(std::ranges::find_if(phones, is_vowel) - phones.begin()));
  if (is_consonant(phones.back())) labels[2] = label(phones.size() - 1);
  return labels;
}

Phone stimulus_phone(const Word& word, std::size_t unit) {
  if (unit == 0) return word.phones.front();
  if (unit == 2) return word.phones.back();
  return *std::ranges::find_if(word.phones, is_vowel);
}

/// Sum of independent yes-or-no draws.
struct Expectation {
  double mean = 0.0;
  double variance = 0.0;
};

/// Condition, unit, stimulus, response.
using Cell = std::tuple<std::size_t, std::size_t, std::string, Label>;

/// `times` answers to each word in each condition, by enumeration.
std::map<Cell, Expectation> enumerate_answers(const Observer& observer,
                                              std::span<const Word> stimuli,
                                              int times) {
  std::map<Cell, Expectation> cells;
  for (const Word& stimulus : stimuli) {
    std::map<std::string, Labels> known;  // by answer
    for (std::size_t c = 0; c < conditions().size(); ++c) {
      std::array<std::map<Label, double>, kPlaceUnits.size()> probabilities;
      for (const auto& [answer, probability] :
           observer.answers(stimulus, conditions()[c].presented)) {
        auto found = known.find(answer.spelling);
        if (found == known.end()) {
          found = known.emplace(answer.spelling, expected_labels(stimulus, answer)).first;
        }
        for (std::size_t unit = 0; unit < kPlaceUnits.size(); ++unit) {
          if (!found->second[unit].empty()) probabilities[unit][found->second[unit]] += probability;
        }
      }
      for (std::size_t unit = 0; unit < kPlaceUnits.size(); ++unit) {
        for (const auto& [label, p] : probabilities[unit]) {
          auto& cell = cells[{c, unit, std::string{symbol(stimulus_phone(stimulus, unit))}, label}];
          cell.mean += times * p;
          cell.variance += times * p * (1.0 - p);
        }
      }
    }
  }
  return cells;
}

Trial trial_of(const Word& stimulus, const Word& answer, const std::string& condition) {
  Trial trial;
  trial.participant = "S01";
  trial.phase = "main";
  trial.condition = condition;
  trial.word = stimulus.spelling;
  trial.phones = stimulus.phones;
  trial.response = answer.spelling;
  trial.simulated = true;
  return trial;
}

std::vector<Trial> draw_trials(const Observer& observer, std::span<const Word> stimuli, int times) {
  std::vector<Trial> trials;
  for (const auto& [name, presented] : conditions()) {
    Random random{derive_seed(2, "recovery " + name)};
    for (int time = 0; time < times; ++time) {
      for (const Word& stimulus : stimuli) {
        trials.push_back(trial_of(stimulus, observer.answer(stimulus, presented, random), name));
      }
    }
  }
  return trials;
}

/// As the report counts: every cell that occurs, and the ambiguous answers of each unit.
struct Counted {
  std::map<Cell, double> cells;
  std::map<std::pair<std::size_t, std::size_t>, double> ambiguous;  ///< by condition, unit
};

Counted count(std::span<const Trial> trials) {
  std::vector<std::string> names;
  for (const auto& condition : conditions()) names.push_back(condition.name);
  const auto scores = score_all(trials, installed_dictionary());
  Counted counted;
  for (const auto& table : tabulate_confusions(trials, scores, names)) {
    const auto c =
        static_cast<std::size_t>(std::ranges::find(names, table.condition) - names.begin());
    const auto unit = static_cast<std::size_t>(table.unit);
    counted.ambiguous[{c, unit}] = static_cast<double>(table.ambiguous);
    const auto& matrix = table.matrix;
    for (std::size_t s = 0; s < matrix.stimuli().size(); ++s) {
      for (std::size_t r = 0; r < matrix.responses().size(); ++r) {
        if (matrix.count(s, r) == 0) continue;
        counted.cells[{c, unit, matrix.stimuli()[s], matrix.responses()[r]}] =
            static_cast<double>(matrix.count(s, r));
      }
    }
  }
  return counted;
}

/// Mean squared deviation in units of the variance, over cells expected at least 5 times.
struct Fit {
  int cells = 0;
  double mean_square = 0.0;
};

Fit fit(const std::map<Cell, Expectation>& expected,
        const std::map<Cell, double>& counted,
        std::size_t expected_condition,
        std::size_t counted_condition) {
  Fit found;
  for (const auto& [cell, expectation] : expected) {
    const auto& [c, unit, stimulus, label] = cell;
    if (c != expected_condition || label == kAmbiguous || expectation.mean < 5.0) continue;
    if (expectation.variance < 1.0) continue;
    const auto at = counted.find({counted_condition, unit, stimulus, label});
    const double deviation = (at == counted.end() ? 0.0 : at->second) - expectation.mean;
    found.mean_square += deviation * deviation / expectation.variance;
    ++found.cells;
  }
  found.mean_square /= found.cells;
  return found;
}

class Recovery : public testing::Test {
 protected:
  static constexpr int kTimes = 20;  ///< as many participants as words in each condition

  static void SetUpTestSuite() {
    stimuli_ = words("monosyllables-414.json");
    const auto observer = typical(words("familiar-monosyllables.json"));
    expected_ = enumerate_answers(observer, stimuli_, kTimes);
    counted_ = count(draw_trials(observer, stimuli_, kTimes));
  }

  static inline std::vector<Word> stimuli_;
  static inline std::map<Cell, Expectation> expected_;
  static inline Counted counted_;
};

TEST_F(Recovery, EveryCellOfTheReportIsWithinSamplingErrorOfTheEnumeration) {
  // Cells are thousands and rare ones are not normal: 5 sigma, and 2 counts for the rare.
  const auto is_near = [](double counted, const Expectation& expected) {
    return std::abs(counted - expected.mean) <= 2.0 + 5.0 * std::sqrt(expected.variance);
  };
  std::map<std::pair<std::size_t, std::size_t>, Expectation> ambiguous;
  for (const auto& [cell, expectation] : expected_) {
    const auto& [c, unit, stimulus, label] = cell;
    if (label == kAmbiguous) {
      ambiguous[{c, unit}].mean += expectation.mean;
      ambiguous[{c, unit}].variance += expectation.variance;
      continue;
    }
    const auto at = counted_.cells.find(cell);
    const double counted = at == counted_.cells.end() ? 0.0 : at->second;
    EXPECT_TRUE(is_near(counted, expectation))
        << conditions()[c].name << ", " << name(kPlaceUnits.at(unit)) << ", " << stimulus << " as "
        << label << ": " << counted << ", expected " << expectation.mean;
  }
  for (const auto& [cell, counted] : counted_.cells) {
    EXPECT_TRUE(expected_.contains(cell)) << std::get<2>(cell) << " as " << std::get<3>(cell);
  }
  for (const auto& [unit, counted] : counted_.ambiguous) {
    EXPECT_TRUE(is_near(counted, ambiguous[unit])) << counted << ", " << ambiguous[unit].mean;
  }
}

TEST_F(Recovery, DeviationsTogetherAreAsLargeAsChanceMakesThem) {
  for (std::size_t c = 0; c < conditions().size(); ++c) {
    const auto own = fit(expected_, counted_.cells, c, c);
    ASSERT_GT(own.cells, 100);
    // Each squared deviation has mean 1 and variance about 2.
    EXPECT_NEAR(own.mean_square, 1.0, 5.0 * std::sqrt(2.0 / own.cells)) << conditions()[c].name;
    for (std::size_t other = 0; other < conditions().size(); ++other) {
      if (other == c) continue;
      EXPECT_GT(fit(expected_, counted_.cells, c, other).mean_square, 5.0)
          << "another condition's answers must not pass";
    }
  }
}

TEST_F(Recovery, EveryAnswerIsCountedOnce) {
  for (std::size_t c = 0; c < conditions().size(); ++c) {
    for (std::size_t unit = 0; unit < kPlaceUnits.size(); ++unit) {
      double total = counted_.ambiguous.at({c, unit});
      for (const auto& [cell, counted] : counted_.cells) {
        if (std::get<0>(cell) == c && std::get<1>(cell) == unit) total += counted;
      }
      const auto with_unit = std::ranges::count_if(stimuli_, [&](const Word& word) {
        return place_of(kPlaceUnits.at(unit), word.phones).has_value();
      });
      EXPECT_EQ(total, static_cast<double>(kTimes * with_unit));
    }
  }
}

/// Said in one way only, the way of the list.
bool is_said_in_one_way(const Word& word) {
  const auto said = installed_dictionary().pronunciations(word.spelling);
  return said.size() == 1 && said.front() == word.phones;
}

TEST(ImpliedConfusions, OfSingleConsonantsAreThoseThatTheReportFinds) {
  // With one consonant on each side of the vowel, alignment is by position; answers said in one way
  // leave no choice. So the observer's own enumeration and the scoring must agree exactly.
  auto candidates = words("familiar-monosyllables.json");
  std::erase_if(candidates, [](const Word& word) { return !is_said_in_one_way(word); });
  auto stimuli = words("monosyllables-414.json");
  std::erase_if(stimuli, [](const Word& word) {
    return word.phones.size() != 3 || !is_consonant(word.phones.front()) ||
           !is_vowel(word.phones[1]) || !is_consonant(word.phones.back()) ||
           !is_said_in_one_way(word);
  });
  ASSERT_GT(stimuli.size(), 100U);
  const auto observer = typical(candidates);
  for (const auto& [condition, presented] : conditions()) {
    std::array<protocols::PhoneTable, kPlaceUnits.size()> found;
    double correct = 0.0;
    for (const Word& stimulus : stimuli) {
      for (const auto& [answer, probability] : observer.answers(stimulus, presented)) {
        const auto scored = score(trial_of(stimulus, answer, condition), installed_dictionary());
        if (scored.word_correct()) correct += probability;
        for (std::size_t unit = 0; unit < kPlaceUnits.size(); ++unit) {
          const auto& one = scored.units.at(unit);
          ASSERT_TRUE(one && one->outcome == UnitScore::Outcome::Answered)
              << stimulus.spelling << " as " << answer.spelling;
          found.at(unit)(one->stimulus, one->answer) += probability;
        }
      }
    }
    const auto implied = protocols::implied_confusions(observer, stimuli, presented);
    const std::array tables{&implied.initial, &implied.vowel, &implied.final};
    for (std::size_t unit = 0; unit < kPlaceUnits.size(); ++unit) {
      for (const Phone given : all_phones()) {
        for (const Phone answered : all_phones()) {
          EXPECT_NEAR(found.at(unit)(given, answered), (*tables.at(unit))(given, answered), 1e-9)
              << condition << ": " << symbol(given) << " as " << symbol(answered);
        }
      }
    }
    EXPECT_NEAR(correct, implied.correct, 1e-9);
  }
}

}  // namespace
}  // namespace bimodal::analysis
