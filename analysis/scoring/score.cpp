#include "analysis/scoring/score.hpp"

#include <algorithm>

#include "analysis/scoring/alignment.hpp"
#include "analysis/scoring/spelling.hpp"

namespace bimodal::analysis {

namespace {

using Outcome = UnitScore::Outcome;

constexpr std::array<std::string_view, 5> kVerdicts{
    "correct", "homophone", "wrong", "not in dictionary", "omission"};

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

Verdict judge(const Trial& trial, const std::string& answer, std::span<const Pronunciation> said) {
  if (answer.empty()) return Verdict::Omission;
  const auto word = fold_spelling(trial.word);
  if (answer == word) return Verdict::Correct;
  if (said.empty()) {
    return answer == without_apostrophes(word) ? Verdict::Correct : Verdict::Unknown;
  }
  const bool same_sound = std::ranges::find(said, trial.phones) != said.end();
  return same_sound ? Verdict::Homophone : Verdict::Wrong;
}

UnitScore read_partners(Phone stimulus, const std::vector<Partner>& partners) {
  if (partners.size() > 1) return {stimulus, Outcome::Ambiguous, Phone::Rest};
  const Partner& partner = partners.front();
  if (!partner) return {stimulus, Outcome::Deleted, Phone::Rest};
  return {stimulus, Outcome::Answered, *partner};
}

/// Every unit scored by the same rule; `rule` sees the place among the phones.
template <typename Rule>
void score_units(const Pronunciation& phones, Score& scored, Rule rule) {
  for (const Unit unit : kUnits) {
    if (const auto place = place_of(unit, phones)) {
      scored.units.at(static_cast<std::size_t>(unit)) = rule(*place);
    }
  }
}

}  // namespace

std::string_view name(Verdict verdict) {
  return kVerdicts.at(static_cast<std::size_t>(verdict));
}

Score score(const Trial& trial, const Dictionary& dictionary) {
  const Pronunciation& phones = trial.phones;
  Score scored;
  scored.answer = fold_spelling(trial.response);
  scored.phones = static_cast<int>(phones.size());
  const auto said = look_up(dictionary, scored.answer);
  scored.verdict = judge(trial, scored.answer, said);
  switch (scored.verdict) {
    case Verdict::Correct:
    case Verdict::Homophone:
      scored.phones_correct = scored.phones;
      score_units(phones, scored, [&](std::size_t place) {
        return UnitScore{phones[place], Outcome::Answered, phones[place]};
      });
      break;
    case Verdict::Wrong: {
      const auto alignment = align_with_any(phones, said);
      scored.phones_correct = alignment.matches;
      score_units(phones, scored, [&](std::size_t place) {
        return read_partners(phones[place], alignment.partners[place]);
      });
      break;
    }
    case Verdict::Unknown:
      score_units(phones, scored, [&](std::size_t place) {
        return UnitScore{phones[place], Outcome::Other, Phone::Rest};
      });
      break;
    case Verdict::Omission:
      scored.phones_correct = 0;
      score_units(phones, scored, [&](std::size_t place) {
        return UnitScore{phones[place], Outcome::Blank, Phone::Rest};
      });
      break;
  }
  return scored;
}

std::vector<Score> score_all(std::span<const Trial> trials, const Dictionary& dictionary) {
  std::vector<Score> scores;
  scores.reserve(trials.size());
  for (const auto& trial : trials) scores.push_back(score(trial, dictionary));
  return scores;
}

}  // namespace bimodal::analysis
