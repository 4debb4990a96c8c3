#include "protocols/observers/implied_confusions.hpp"

#include <algorithm>

namespace bimodal::protocols {

ImpliedConfusions implied_confusions(const Observer& observer,
                                     std::span<const Word> stimuli,
                                     const Presented& presented) {
  ImpliedConfusions expected;
  for (const Word& stimulus : stimuli) {
    const auto& given = stimulus.phones;
    const auto vowel =
        static_cast<std::size_t>(std::ranges::find_if(given, is_vowel) - given.begin());
    const bool has_one_vowel = std::ranges::count_if(given, is_vowel) == 1;
    for (const auto& [word, probability] : observer.answers(stimulus, presented)) {
      const auto& heard = word.phones;
      if (is_consonant(given.front()))
        expected.initial(given.front(), heard.front()) += probability;
      if (has_one_vowel) expected.vowel(given[vowel], heard[vowel]) += probability;
      if (is_consonant(given.back())) expected.final(given.back(), heard.back()) += probability;
      if (heard == given) expected.correct += probability;
    }
  }
  return expected;
}

}  // namespace bimodal::protocols
