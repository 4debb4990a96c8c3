#include "analysis/scoring/lexical_equivalence.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace bimodal::analysis {

namespace {

/// A phone's class, named by the first of its members.
using ClassOfPhone = std::array<Phone, kPhoneCount>;

ClassOfPhone each_alone() {
  ClassOfPhone classes{};
  for (const Phone phone : all_phones()) classes.at(static_cast<std::size_t>(phone)) = phone;
  return classes;
}

ClassOfPhone put_together(const std::vector<std::vector<std::string>>& members) {
  auto classes = each_alone();
  for (const auto& made : members) {
    std::optional<Phone> first;
    for (const auto& label : made) {
      const auto phone = phone_from_symbol(label);
      if (!phone) continue;
      if (!first) first = phone;
      classes.at(static_cast<std::size_t>(*phone)) = *first;
    }
  }
  return classes;
}

/// How many words have each sequence of classes.
std::unordered_map<std::string, std::size_t> count(const Dictionary& dictionary,
                                                   const ClassOfPhone& classes) {
  std::unordered_map<std::string, std::size_t> counts;
  std::string key;
  for (const auto& spelling : dictionary.spellings()) {
    key.clear();
    for (const Phone phone : dictionary.pronunciations(spelling).front()) {
      key += static_cast<char>(classes.at(static_cast<std::size_t>(phone)));
    }
    ++counts[key];
  }
  return counts;
}

std::size_t singletons(const std::unordered_map<std::string, std::size_t>& counts) {
  std::size_t alone = 0;
  for (const auto& [key, words] : counts) alone += words == 1 ? 1U : 0U;
  return alone;
}

}  // namespace

LexicalEquivalence lexical_equivalence(const Dictionary& dictionary,
                                       const std::vector<std::vector<std::string>>& classes) {
  LexicalEquivalence found{.words = dictionary.spellings().size()};
  if (found.words == 0) return found;
  const auto counts = count(dictionary, put_together(classes));
  found.classes = counts.size();
  found.unique = singletons(counts);
  found.unique_by_sound = singletons(count(dictionary, each_alone()));
  const auto n = static_cast<double>(found.words);
  found.unique_share = static_cast<double>(found.unique) / n;
  double entropy = 0.0;
  for (const auto& [key, words] : counts) {
    const auto size = static_cast<double>(words);
    found.expected_size += size * size / n;
    entropy -= size / n * std::log2(size / n);
  }
  found.extracted = found.words == 1 ? 1.0 : entropy / std::log2(n);
  return found;
}

}  // namespace bimodal::analysis
