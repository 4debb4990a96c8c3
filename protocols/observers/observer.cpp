#include "protocols/observers/observer.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace bimodal::protocols {

namespace {

std::vector<double> weights(const Word& stimulus,
                            std::span<const Word* const> candidates,
                            const PhoneTable& table) {
  std::vector<double> products(candidates.size(), 1.0);
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    for (std::size_t i = 0; i < stimulus.phones.size(); ++i) {
      products[c] *= table(stimulus.phones[i], candidates[c]->phones[i]);
    }
  }
  return products;
}

}  // namespace

Observer::Observer(ObserverDescription description, std::span<const Word> candidates)
    : description_{std::move(description)} {
  for (const Word& word : candidates) by_shape_[shape_of(word)].push_back(word);
}

Observer::Shape Observer::shape_of(const Word& word) {
  assert(!word.phones.empty());
  Shape shape;
  for (const Phone phone : word.phones) {
    assert(phone != Phone::Rest);
    shape.push_back(is_vowel(phone));
  }
  return shape;
}

std::vector<const Word*> Observer::candidates_for(const Word& stimulus) const {
  std::vector<const Word*> words;
  if (const auto group = by_shape_.find(shape_of(stimulus)); group != by_shape_.end()) {
    words.reserve(group->second.size() + 1);
    for (const Word& word : group->second) words.push_back(&word);
  }
  if (std::ranges::none_of(words, [&](const Word* word) { return *word == stimulus; })) {
    words.push_back(&stimulus);
  }
  return words;
}

Word Observer::answer(const Word& stimulus, const Presented& presented, Random& random) const {
  const auto words = candidates_for(stimulus);
  return *words[random.weighted(weights(stimulus, words, confusions(description_, presented)))];
}

std::vector<Observer::Answer> Observer::answers(const Word& stimulus,
                                                const Presented& presented) const {
  const auto words = candidates_for(stimulus);
  const auto products = weights(stimulus, words, confusions(description_, presented));
  const double sum = std::accumulate(products.begin(), products.end(), 0.0);
  std::vector<Answer> answers;
  for (std::size_t c = 0; c < words.size(); ++c) {
    if (products[c] > 0.0) answers.push_back({*words[c], products[c] / sum});
  }
  return answers;
}

}  // namespace bimodal::protocols
