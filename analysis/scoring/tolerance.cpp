#include "analysis/scoring/tolerance.hpp"

#include <algorithm>
#include <array>

#include "analysis/scoring/verb_forms.hpp"
#include "stimuli/words/number_words.hpp"

namespace bimodal::analysis {

namespace {

constexpr std::string_view kVowelLetters = "aeiou";

std::string with_each_letter_once(std::string_view text) {
  std::string single{text};
  single.erase(std::unique(single.begin(), single.end()), single.end());
  return single;
}

bool takes_es(std::string_view word) {
  constexpr std::array<std::string_view, 6> kEndings{"s", "x", "z", "ch", "sh", "o"};
  return std::ranges::any_of(kEndings, [&](auto ending) { return word.ends_with(ending); });
}

bool ends_in_consonant_and_y(std::string_view word) {
  return word.size() > 1 && word.ends_with('y') &&
         kVowelLetters.find(word[word.size() - 2]) == std::string_view::npos;
}

bool is_plural_of(std::string_view plural, std::string_view singular) {
  const std::string word{singular};
  if (ends_in_consonant_and_y(word)) return plural == word.substr(0, word.size() - 1) + "ies";
  if (takes_es(word) && plural == word + "es") return true;
  return !word.ends_with('s') && plural == word + "s";
}

/// A contraction and what it stands for, folded; several lines where it may stand for several.
struct Contraction {
  std::string_view contracted;
  std::string_view full;
};

constexpr std::array kContractions = std::to_array<Contraction>({
    {"aren't", "arenot"},       {"can't", "cannot"},       {"couldn't", "couldnot"},
    {"didn't", "didnot"},       {"doesn't", "doesnot"},    {"don't", "donot"},
    {"hadn't", "hadnot"},       {"hasn't", "hasnot"},      {"haven't", "havenot"},
    {"isn't", "isnot"},         {"mightn't", "mightnot"},  {"mustn't", "mustnot"},
    {"needn't", "neednot"},     {"oughtn't", "oughtnot"},  {"shan't", "shallnot"},
    {"shouldn't", "shouldnot"}, {"wasn't", "wasnot"},      {"weren't", "werenot"},
    {"won't", "willnot"},       {"wouldn't", "wouldnot"},  {"i'm", "iam"},
    {"you're", "youare"},       {"we're", "weare"},        {"they're", "theyare"},
    {"he's", "heis"},           {"he's", "hehas"},         {"she's", "sheis"},
    {"she's", "shehas"},        {"it's", "itis"},          {"it's", "ithas"},
    {"that's", "thatis"},       {"that's", "thathas"},     {"what's", "whatis"},
    {"what's", "whathas"},      {"who's", "whois"},        {"who's", "whohas"},
    {"where's", "whereis"},     {"where's", "wherehas"},   {"when's", "whenis"},
    {"why's", "whyis"},         {"how's", "howis"},        {"there's", "thereis"},
    {"there's", "therehas"},    {"here's", "hereis"},      {"let's", "letus"},
    {"i've", "ihave"},          {"you've", "youhave"},     {"we've", "wehave"},
    {"they've", "theyhave"},    {"could've", "couldhave"}, {"should've", "shouldhave"},
    {"would've", "wouldhave"},  {"might've", "mighthave"}, {"must've", "musthave"},
    {"i'll", "iwill"},          {"i'll", "ishall"},        {"you'll", "youwill"},
    {"he'll", "hewill"},        {"she'll", "shewill"},     {"it'll", "itwill"},
    {"we'll", "wewill"},        {"we'll", "weshall"},      {"they'll", "theywill"},
    {"that'll", "thatwill"},    {"there'll", "therewill"}, {"who'll", "whowill"},
    {"i'd", "iwould"},          {"i'd", "ihad"},           {"you'd", "youwould"},
    {"you'd", "youhad"},        {"he'd", "hewould"},       {"he'd", "hehad"},
    {"she'd", "shewould"},      {"she'd", "shehad"},       {"we'd", "wewould"},
    {"we'd", "wehad"},          {"they'd", "theywould"},   {"they'd", "theyhad"},
    {"it'd", "itwould"},        {"it'd", "ithad"},         {"who'd", "whowould"},
    {"who'd", "whohad"},        {"o'clock", "oftheclock"}, {"ma'am", "madam"},
    {"y'all", "youall"},
});

bool is_number_said_so(std::string_view digits, std::string_view said) {
  return is_number(digits) && said_number(digits) == said;
}

bool applies(Tolerance rule, std::string_view word, std::string_view answer, bool is_a_word) {
  switch (rule) {
    case Tolerance::DoubleLetters:
      return !is_a_word && differ_in_doubled_letters(word, answer);
    case Tolerance::Plural:
      return differ_in_number(word, answer);
    case Tolerance::Tense:
      return differ_in_tense(word, answer);
    case Tolerance::Contractions:
      return differ_in_contraction(word, answer);
    case Tolerance::Numbers:
      return is_number_said_so(word, answer) || is_number_said_so(answer, word);
    case Tolerance::Compounds:
      break;
  }
  return false;
}

}  // namespace

std::optional<Tolerance> tolerated(std::string_view word,
                                   std::string_view answer,
                                   bool is_a_word,
                                   const ScoringRules& rules) {
  for (const Tolerance rule : kTolerances) {
    if (rules.tolerates(rule) && applies(rule, word, answer, is_a_word)) return rule;
  }
  return std::nullopt;
}

bool differ_in_doubled_letters(std::string_view one, std::string_view other) {
  return with_each_letter_once(one) == with_each_letter_once(other);
}

bool differ_in_number(std::string_view one, std::string_view other) {
  return is_plural_of(one, other) || is_plural_of(other, one);
}

bool differ_in_tense(std::string_view one, std::string_view other) {
  return are_forms_of_a_verb(one, other);
}

bool differ_in_contraction(std::string_view one, std::string_view other) {
  return std::ranges::any_of(kContractions, [&](const Contraction& line) {
    return (line.contracted == one && line.full == other) ||
           (line.contracted == other && line.full == one);
  });
}

bool is_number(std::string_view folded) {
  return !folded.empty() &&
         std::ranges::all_of(folded, [](char letter) { return letter >= '0' && letter <= '9'; });
}

std::string said_number(std::string_view digits) {
  std::string said;
  for (const auto word : number_words(digits)) said += word;
  return said;
}

}  // namespace bimodal::analysis
