#include "stimuli/labels/labels.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "stimuli/labels/phone_name.hpp"

namespace bimodal {

namespace {

constexpr std::array<std::string_view, 6> kPhoneTiers{
    "phones", "phone", "segments", "segment", "phonemes", "phoneme"};
constexpr std::array<std::string_view, 4> kWordTiers{"words", "word", "text", "orthography"};
constexpr std::array<std::string_view, 10> kSilences{
    "sil", "sp", "pau", "rest", "#", "h#", "<sil>", "<p:>", "_", "..."};

char small(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

bool is_one_of(std::string_view text, std::span<const std::string_view> names) {
  return std::ranges::any_of(
      names, [&](std::string_view name) { return std::ranges::equal(text, name, {}, small); });
}

const Tier* first_of(const Labels& labels, std::span<const std::string_view> names) {
  const auto found = std::ranges::find_if(
      labels.tiers, [&](const Tier& tier) { return is_one_of(tier.name, names); });
  return found == labels.tiers.end() ? nullptr : &*found;
}

}  // namespace

const Tier* phone_tier(const Labels& labels) {
  return first_of(labels, kPhoneTiers);
}

const Tier* word_tier(const Labels& labels) {
  return first_of(labels, kWordTiers);
}

bool is_silence(std::string_view text) {
  return text.empty() || is_one_of(text, kSilences);
}

std::vector<Label> not_phones(const Tier& tier) {
  std::vector<Label> unknown;
  std::ranges::copy_if(tier.labels, std::back_inserter(unknown), [](const Label& label) {
    return phone_name(label.text).kind == PhoneName::Kind::Unknown;
  });
  return unknown;
}

Labels labels_of(const Utterance& utterance, std::vector<Label> words) {
  Labels labels{.end = utterance.end(), .tiers = {}};
  if (!words.empty()) {
    labels.end = std::max(labels.end, words.back().end);
    labels.tiers.push_back({.name = "words", .labels = std::move(words)});
  }
  Tier phones{.name = "phones", .labels = {}};
  for (const auto& timed : utterance.phones) {
    if (timed.duration <= Duration{}) continue;
    const bool rest = timed.phone == Phone::Rest;
    phones.labels.push_back({.start = timed.start,
                             .end = timed.end(),
                             .text = std::string{rest ? "sil" : symbol(timed.phone)}});
  }
  labels.tiers.push_back(std::move(phones));
  return labels;
}

}  // namespace bimodal
