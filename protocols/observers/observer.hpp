#pragma once

#include <map>
#include <span>
#include <vector>

#include "protocols/observers/observer_description.hpp"
#include "stimuli/base/random.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal::protocols {

/// A simulated listener. It answers with one of its candidate words: with one that has consonants
/// and vowels in the same order as the stimulus (for a monosyllable: as many consonants before the
/// vowel and after it), with a probability proportional to the product, over the positions, of
/// P(its phone | the stimulus's phone) in the confusion table for what is presented. The stimulus
/// itself is always a candidate. Immutable: any thread may ask.
class Observer {
 public:
  struct Answer {
    Word word;
    double probability = 0.0;
  };

  /// `candidates` are usually stimuli/assets/words/familiar-monosyllables.json. The description
  /// must have been read without errors.
  Observer(ObserverDescription description, std::span<const Word> candidates);

  [[nodiscard]] const ObserverDescription& description() const { return description_; }

  /// Draws one answer; takes one number from `random`.
  [[nodiscard]] Word answer(const Word& stimulus, const Presented& presented, Random& random) const;

  /// All possible answers, of probability above 0, in the order of the candidates. They sum to 1.
  [[nodiscard]] std::vector<Answer> answers(const Word& stimulus, const Presented& presented) const;

 private:
  /// Which positions have vowels.
  using Shape = std::vector<bool>;

  /// The candidates of the stimulus's shape, and behind them the stimulus if it is not one.
  [[nodiscard]] std::vector<const Word*> candidates_for(const Word& stimulus) const;

  static Shape shape_of(const Word& word);

  ObserverDescription description_;
  std::map<Shape, std::vector<Word>> by_shape_;
};

}  // namespace bimodal::protocols
