#include "analysis/scoring/score.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "analysis/scoring/spelling.hpp"
#include "analysis/scoring/tolerance.hpp"
#include "stimuli/words/number_words.hpp"

namespace bimodal::analysis {

namespace {

using Outcome = UnitScore::Outcome;

constexpr std::array<std::string_view, kVerdictCount> kVerdicts{
    "correct", "homophone", "tolerated", "wrong", "not in dictionary", "omission"};

std::string without_apostrophes(std::string text) {
  std::erase(text, '\'');
  return text;
}

/// Of the spelling as it is, else without apostrophes.
std::span<const Pronunciation> look_up(const Dictionary& dictionary, const std::string& folded) {
  const auto found = dictionary.pronunciations(folded);
  if (!found.empty() || folded.find('\'') == std::string::npos) return found;
  return dictionary.pronunciations(without_apostrophes(folded));
}

/// The words of an answer as it was typed, folded: what spaces and hyphens part.
std::vector<std::string> words_of(std::string_view response) {
  constexpr std::string_view kParting = " \t-";
  std::vector<std::string> words;
  while (!response.empty()) {
    const auto part = response.substr(0, response.find_first_of(kParting));
    response.remove_prefix(std::min(part.size() + 1, response.size()));
    if (auto word = fold_spelling(part); !word.empty()) words.push_back(std::move(word));
  }
  return words;
}

/// As the dictionary writes what the letter-to-sound rules tell apart.
Phone as_in_dictionary(Phone phone) {
  if (phone == Phone::WH) return Phone::W;
  return phone == Phone::AX ? Phone::AH : phone;
}

UnitScore read_partners(Phone stimulus, const std::vector<PartnerCount>& partners) {
  if (partners.size() > 1) return {stimulus, Outcome::Ambiguous, Phone::Rest};
  const Partner& partner = partners.front().partner;
  if (!partner) return {stimulus, Outcome::Deleted, Phone::Rest};
  return {stimulus, Outcome::Answered, *partner};
}

void score_aligned(const Pronunciation& phones,
                   std::span<const Pronunciation> said,
                   AlignmentCosts costs,
                   Score& scored) {
  const auto [alignment, best] = align_with_any(phones, said, costs);
  scored.phones_correct = alignment.matches;
  scored.insertions = alignment.insertions;
  scored.places.reserve(phones.size());
  for (std::size_t place = 0; place < phones.size(); ++place) {
    const auto& partners = alignment.partners[place];
    scored.places.push_back(read_partners(phones[place], partners));
    if (partners.size() == 1) continue;
    for (const auto& [partner, alignments] : partners) {
      scored.shares.push_back(
          {static_cast<std::uint32_t>(place), partner, alignments / alignment.alignments});
    }
  }
  scored.shares.shrink_to_fit();
  scored.said.reserve(best.size());
  for (const auto& [pronunciation, alignments] : best) {
    scored.said.push_back({said[pronunciation], alignments / alignment.alignments});
  }
}

/// Every phone has the same outcome; where answered, with itself.
void score_alike(const Pronunciation& phones, Outcome outcome, Score& scored) {
  scored.places.reserve(phones.size());
  for (const Phone phone : phones) {
    const Phone answer = outcome == Outcome::Answered ? phone : Phone::Rest;
    scored.places.push_back({phone, outcome, answer});
  }
}

}  // namespace

struct Scorer::Sound {
  std::span<const Pronunciation> of_dictionary;
  std::vector<Pronunciation> made;  ///< of its words or by rules, where the dictionary has none
  bool known = true;                ///< to the dictionary, at least in parts

  [[nodiscard]] std::span<const Pronunciation> all() const {
    return made.empty() ? of_dictionary : std::span{made};
  }
};

std::string_view name(Verdict verdict) {
  return kVerdicts.at(static_cast<std::size_t>(verdict));
}

Scorer::Scorer(const Dictionary& dictionary, const ScoringRules& rules)
    : dictionary_{dictionary}, rules_{rules} {
  if (rules.out_of_dictionary == OutOfDictionary::LetterToSound) {
    letter_to_sound_ = LetterToSound::shipped();
  }
}

Score Scorer::score(const Trial& trial) const {
  const Pronunciation& phones = trial.phones;
  Score scored;
  scored.answer = fold_spelling(trial.response);
  scored.phones = static_cast<int>(phones.size());
  scored.ties = rules_.ties;
  const auto sound = sound_of(trial, scored.answer);
  judge(trial, sound, scored);
  if (phones.empty()) return scored;
  if (scored.word_correct()) {
    scored.phones_correct = scored.phones;
    score_alike(phones, Outcome::Answered, scored);
  } else if (scored.verdict == Verdict::Omission) {
    scored.phones_correct = 0;
    score_alike(phones, Outcome::Blank, scored);
  } else if (sound.all().empty()) {
    score_alike(phones, Outcome::Other, scored);
  } else {
    score_aligned(phones, sound.all(), rules_.costs, scored);
  }
  for (const Unit unit : kPlaceUnits) {
    if (const auto place = place_of(unit, phones)) {
      scored.units.at(static_cast<std::size_t>(unit)) = scored.places[*place];
    }
  }
  return scored;
}

void Scorer::judge(const Trial& trial, const Sound& sound, Score& scored) const {
  const auto word = fold_spelling(trial.word);
  const auto& answer = scored.answer;
  if (answer.empty()) {
    scored.verdict = Verdict::Omission;
    return;
  }
  const bool is_a_word = !sound.of_dictionary.empty();
  if (answer == word || (!is_a_word && answer == without_apostrophes(word))) {
    scored.verdict = Verdict::Correct;
    return;
  }
  const auto said = sound.all();
  if (rules_.homophones && std::ranges::find(said, trial.phones) != said.end()) {
    scored.verdict = Verdict::Homophone;
    return;
  }
  scored.tolerance = tolerated(word, answer, is_a_word, rules_);
  if (scored.tolerance) {
    scored.verdict = Verdict::Tolerated;
  } else {
    scored.verdict = sound.known ? Verdict::Wrong : Verdict::Unknown;
  }
}

Scorer::Sound Scorer::sound_of(const Trial& trial, const std::string& folded) const {
  Sound sound{.of_dictionary = look_up(dictionary_, folded), .made = {}, .known = true};
  if (!sound.of_dictionary.empty() || folded.empty()) return sound;
  if (auto parts = said_in_parts(trial, folded)) {
    sound.made.push_back(std::move(*parts));
    return sound;
  }
  sound.known = false;
  if (auto phones = said_by_rules(folded); !phones.empty()) sound.made.push_back(std::move(phones));
  return sound;
}

std::optional<Pronunciation> Scorer::said_in_parts(const Trial& trial,
                                                   const std::string& folded) const {
  std::vector<std::string> parts;
  if (rules_.tolerates(Tolerance::Numbers) && is_number(folded)) {
    for (const auto word : number_words(folded)) parts.emplace_back(word);
  } else if (rules_.tolerates(Tolerance::Compounds)) {
    parts = words_of(trial.response);
  }
  if (parts.empty()) return std::nullopt;
  Pronunciation said;
  for (const auto& part : parts) {
    const auto found = look_up(dictionary_, part);
    if (found.empty()) return std::nullopt;
    said.insert(said.end(), found.front().begin(), found.front().end());
  }
  return said;
}

Pronunciation Scorer::said_by_rules(const std::string& folded) const {
  Pronunciation said;
  if (!letter_to_sound_) return said;
  for (const auto& word : letter_to_sound_->words(folded)) {
    std::ranges::transform(word.phones, std::back_inserter(said), as_in_dictionary);
  }
  return said;
}

Score score(const Trial& trial, const Dictionary& dictionary, const ScoringRules& rules) {
  return Scorer{dictionary, rules}.score(trial);
}

std::vector<Score> score_all(std::span<const Trial> trials,
                             const Dictionary& dictionary,
                             const ScoringRules& rules) {
  const Scorer scorer{dictionary, rules};
  std::vector<Score> scores;
  scores.reserve(trials.size());
  for (const auto& trial : trials) scores.push_back(scorer.score(trial));
  return scores;
}

}  // namespace bimodal::analysis
