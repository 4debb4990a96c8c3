#include "protocols/observers/phone_table.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace bimodal::protocols {

namespace {

/// A table whose cells between phones of the same kind are computed.
template <typename Cell>
PhoneTable filled(Cell cell) {
  PhoneTable table;
  for (const Phone stimulus : all_phones()) {
    for (const Phone response : all_phones()) {
      if (same_kind(stimulus, response)) table(stimulus, response) = cell(stimulus, response);
    }
  }
  return table;
}

}  // namespace

double PhoneTable::row_sum(Phone stimulus) const {
  const auto& row = cells_[index(stimulus)];
  return std::accumulate(row.begin(), row.end(), 0.0);
}

bool same_kind(Phone one, Phone other) {
  return (is_vowel(one) && is_vowel(other)) || (is_consonant(one) && is_consonant(other));
}

PhoneTable identity_confusions() {
  return filled([](Phone stimulus, Phone response) { return stimulus == response ? 1.0 : 0.0; });
}

PhoneTable uniform_confusions() {
  const auto vowels = static_cast<double>(std::ranges::count_if(all_phones(), is_vowel));
  const auto consonants = static_cast<double>(std::ranges::count_if(all_phones(), is_consonant));
  return filled(
      [&](Phone stimulus, Phone) { return 1.0 / (is_vowel(stimulus) ? vowels : consonants); });
}

PhoneTable mixture(const PhoneTable& one, const PhoneTable& other, double weight) {
  assert(weight >= 0.0 && weight <= 1.0);
  return filled([&](Phone stimulus, Phone response) {
    return (1.0 - weight) * one(stimulus, response) + weight * other(stimulus, response);
  });
}

PhoneTable fuzzy_product(const PhoneTable& auditory, const PhoneTable& visual) {
  PhoneTable product = filled([&](Phone stimulus, Phone response) {
    return auditory(stimulus, response) * visual(stimulus, response);
  });
  for (const Phone stimulus : all_phones().subspan(1)) {
    const double sum = product.row_sum(stimulus);
    assert(sum > 0.0);
    for (const Phone response : all_phones()) product(stimulus, response) /= sum;
  }
  return product;
}

}  // namespace bimodal::protocols
