#include "analysis/scoring/label_pair.hpp"

#include <algorithm>
#include <cassert>
#include <span>

#include "analysis/scoring/spelling.hpp"

namespace bimodal::analysis {

namespace {

using Outcome = UnitScore::Outcome;
using Pairs = std::vector<LabelPair>;

bool is_cluster(Unit unit) {
  return unit == Unit::Onset || unit == Unit::Coda;
}

std::string cluster_of(std::span<const Phone> phones, Unit unit) {
  auto cluster = spell(unit == Unit::Onset ? onset_of(phones) : coda_of(phones));
  return cluster.empty() ? std::string{kNoConsonant} : cluster;
}

std::string word_label(std::string folded) {
  const bool taken = folded == kBlank || folded == kDeleted || folded == kOther;
  return taken ? "'" + folded + "'" : std::move(folded);
}

std::string partner_label(const Partner& partner) {
  return std::string{partner ? symbol(*partner) : kDeleted};
}

/// Of a place that is not ambiguous.
std::string_view label(const UnitScore& place) {
  switch (place.outcome) {
    case Outcome::Answered:
      return symbol(place.answer);
    case Outcome::Deleted:
      return kDeleted;
    case Outcome::Blank:
      return kBlank;
    case Outcome::Other:
    case Outcome::Ambiguous:
      break;
  }
  return kOther;
}

void add_place(const Score& score, std::size_t place, Pairs& pairs) {
  const auto& found = score.places[place];
  const std::string stimulus{symbol(found.stimulus)};
  if (found.outcome != Outcome::Ambiguous) {
    pairs.push_back({stimulus, std::string{label(found)}});
    return;
  }
  if (score.ties == TieRule::LeftOut) return;
  for (const auto& share : score.shares) {
    if (share.place == place)
      pairs.push_back({stimulus, partner_label(share.partner), share.share});
  }
}

/// Answers said in several equally good ways may have the same onset all the same.
Pairs shared_clusters(const std::string& stimulus, const Score& score, Unit unit) {
  Pairs pairs;
  for (const auto& said : score.said) {
    auto response = cluster_of(said.phones, unit);
    const auto known = std::ranges::find(pairs, response, &LabelPair::response);
    if (known != pairs.end()) {
      known->weight += said.share;
    } else {
      pairs.push_back({stimulus, std::move(response), said.share});
    }
  }
  if (pairs.size() == 1) pairs.front().weight = 1.0;
  if (pairs.size() > 1 && score.ties == TieRule::LeftOut) pairs.clear();
  return pairs;
}

Pairs clusters_of(const Trial& trial, const Score& score, Unit unit) {
  if (std::ranges::none_of(trial.phones, is_vowel)) return {};
  auto stimulus = cluster_of(trial.phones, unit);
  if (score.word_correct()) return {{stimulus, stimulus}};
  if (!score.said.empty()) return shared_clusters(stimulus, score, unit);
  const auto response = score.verdict == Verdict::Omission ? kBlank : kOther;
  return {{std::move(stimulus), std::string{response}}};
}

Pairs words_of(const Trial& trial, const Score& score) {
  auto stimulus = word_label(fold_spelling(trial.word));
  if (score.word_correct()) return {{stimulus, stimulus}};
  if (score.verdict == Verdict::Omission) return {{std::move(stimulus), std::string{kBlank}}};
  return {{std::move(stimulus), word_label(score.answer)}};
}

}  // namespace

std::vector<std::string> stimuli_of(const Trial& trial, Unit unit) {
  if (unit == Unit::Word) return {word_label(fold_spelling(trial.word))};
  if (is_cluster(unit)) {
    if (std::ranges::none_of(trial.phones, is_vowel)) return {};
    return {cluster_of(trial.phones, unit)};
  }
  std::vector<std::string> stimuli;
  if (unit == Unit::Phoneme) {
    for (const Phone phone : trial.phones) stimuli.emplace_back(symbol(phone));
  } else if (const auto place = place_of(unit, trial.phones)) {
    stimuli.emplace_back(symbol(trial.phones[*place]));
  }
  return stimuli;
}

std::vector<LabelPair> confusions_of(const Trial& trial, const Score& score, Unit unit) {
  assert(score.places.size() == trial.phones.size());
  if (unit == Unit::Word) return words_of(trial, score);
  if (is_cluster(unit)) return clusters_of(trial, score, unit);
  Pairs pairs;
  if (unit == Unit::Phoneme) {
    for (std::size_t place = 0; place < score.places.size(); ++place) {
      add_place(score, place, pairs);
    }
  } else if (const auto place = place_of(unit, trial.phones)) {
    add_place(score, *place, pairs);
  }
  return pairs;
}

}  // namespace bimodal::analysis
