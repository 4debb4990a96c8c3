#include "analysis/scoring/verb_forms.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace bimodal::analysis {

namespace {

constexpr std::string_view kVowelLetters = "aeiou";
constexpr std::string_view kVowelLettersAndY = "aeiouy";

/// The irregular verbs: the base, then its other forms but for -ing.
constexpr std::array kIrregular = std::to_array<std::string_view>({
    "be am is are was were been",
    "beat beaten",
    "become became",
    "begin began begun",
    "bend bent",
    "bind bound",
    "bite bit bitten",
    "bleed bled",
    "blow blew blown",
    "break broke broken",
    "breed bred",
    "bring brought",
    "build built",
    "burn burnt burned",
    "buy bought",
    "catch caught",
    "choose chose chosen",
    "cling clung",
    "come came",
    "creep crept",
    "deal dealt",
    "dig dug",
    "do did done",
    "draw drew drawn",
    "dream dreamt dreamed",
    "drink drank drunk",
    "drive drove driven",
    "eat ate eaten",
    "fall fell fallen",
    "feed fed",
    "feel felt",
    "fight fought",
    "find found",
    "flee fled",
    "fling flung",
    "fly flew flown",
    "forget forgot forgotten",
    "forgive forgave forgiven",
    "freeze froze frozen",
    "get got gotten",
    "give gave given",
    "go went gone",
    "grind ground",
    "grow grew grown",
    "hang hung",
    "have had",
    "hear heard",
    "hide hid hidden",
    "hold held",
    "keep kept",
    "kneel knelt",
    "know knew known",
    "lay laid",
    "lead led",
    "lean leant leaned",
    "leap leapt leaped",
    "learn learnt learned",
    "leave left",
    "lend lent",
    "lie lay lain",
    "light lit",
    "lose lost",
    "make made",
    "mean meant",
    "meet met",
    "pay paid",
    "ride rode ridden",
    "ring rang rung",
    "rise rose risen",
    "run ran",
    "say said",
    "see saw seen",
    "seek sought",
    "sell sold",
    "send sent",
    "sew sewed sewn",
    "shake shook shaken",
    "shed",
    "shine shone",
    "shoot shot",
    "show showed shown",
    "shrink shrank shrunk",
    "sing sang sung",
    "sink sank sunk",
    "sit sat",
    "sleep slept",
    "slide slid",
    "smell smelt smelled",
    "sow sowed sown",
    "speak spoke spoken",
    "speed sped",
    "spell spelt spelled",
    "spend spent",
    "spill spilt spilled",
    "spin spun",
    "spit spat",
    "spoil spoilt spoiled",
    "spring sprang sprung",
    "stand stood",
    "steal stole stolen",
    "stick stuck",
    "sting stung",
    "stink stank stunk",
    "strike struck",
    "string strung",
    "swear swore sworn",
    "sweep swept",
    "swim swam swum",
    "swing swung",
    "take took taken",
    "teach taught",
    "tear tore torn",
    "tell told",
    "think thought",
    "throw threw thrown",
    "understand understood",
    "wake woke woken",
    "wear wore worn",
    "weave wove woven",
    "weep wept",
    "win won",
    "wind wound",
    "write wrote written",
});

bool is_one_of(std::string_view letters, char letter) {
  return letters.find(letter) != std::string_view::npos;
}

std::vector<std::string> forms_in(std::string_view row) {
  std::vector<std::string> forms;
  while (!row.empty()) {
    const auto form = row.substr(0, row.find(' '));
    forms.emplace_back(form);
    row.remove_prefix(std::min(form.size() + 1, row.size()));
  }
  return forms;
}

/// "stop", "plan": a last consonant behind one vowel letter, which is doubled before -ed and -ing.
bool doubles_its_end(std::string_view base) {
  const auto size = base.size();
  return size >= 3 && !is_one_of("aeiouwxy", base[size - 1]) &&
         is_one_of(kVowelLettersAndY, base[size - 2]) && !is_one_of(kVowelLetters, base[size - 3]);
}

std::vector<std::string> ing_forms(const std::string& base) {
  std::vector<std::string> forms{base + "ing"};
  const auto stem = base.substr(0, base.size() - 1);
  if (base.ends_with("ie")) {
    forms = {base.substr(0, base.size() - 2) + "ying"};
  } else if (base.ends_with('e') && !base.ends_with("ee") && base.size() > 2) {
    forms = {stem + "ing"};
  } else if (doubles_its_end(base)) {
    forms.push_back(base + base.back() + "ing");
  }
  return forms;
}

std::vector<std::string> past_forms(const std::string& base) {
  if (base.ends_with('e')) return {base + "d"};
  const auto size = base.size();
  if (base.ends_with('y') && !is_one_of(kVowelLetters, base[size - 2])) {
    return {base.substr(0, size - 1) + "ied"};
  }
  std::vector<std::string> forms{base + "ed"};
  if (doubles_its_end(base)) forms.push_back(base + base.back() + "ed");
  return forms;
}

/// All forms of every irregular verb, -ing too; a verb's together.
const std::vector<std::vector<std::string>>& irregular_verbs() {
  static const auto verbs = [] {
    std::vector<std::vector<std::string>> made;
    for (const auto row : kIrregular) {
      auto forms = forms_in(row);
      for (auto& form : ing_forms(forms.front())) forms.push_back(std::move(form));
      made.push_back(std::move(forms));
    }
    return made;
  }();
  return verbs;
}

bool has(const std::vector<std::string>& forms, std::string_view form) {
  return std::ranges::find(forms, form) != forms.end();
}

bool is_irregular(std::string_view form) {
  return std::ranges::any_of(irregular_verbs(), [&](const auto& verb) { return has(verb, form); });
}

/// Bases have three letters or more, and one for a vowel besides an e at the end ("the" has none).
bool may_be_base(std::string_view text) {
  return text.size() >= 3 && text.substr(0, text.size() - (text.ends_with('e') ? 1 : 0))
                                     .find_first_of(kVowelLettersAndY) != std::string_view::npos;
}

void append_stems(const std::string& stem, std::vector<std::string>& bases) {
  bases.push_back(stem);
  bases.push_back(stem + "e");
  if (stem.size() > 1 && stem.back() == stem[stem.size() - 2]) {
    bases.push_back(stem.substr(0, stem.size() - 1));
  }
  if (stem.ends_with('i')) bases.push_back(stem.substr(0, stem.size() - 1) + "y");
  if (stem.ends_with('y')) bases.push_back(stem.substr(0, stem.size() - 1) + "ie");
}

/// Of what a regular verb's form may be a form; whether it is, forms_of() tells.
std::vector<std::string> possible_bases(std::string_view form) {
  const std::string word{form};
  std::vector<std::string> bases{word};
  if (word.size() > 3 && word.ends_with("ing")) {
    append_stems(word.substr(0, word.size() - 3), bases);
  }
  if (word.size() > 2 && word.ends_with("ed")) {
    append_stems(word.substr(0, word.size() - 2), bases);
  }
  std::erase_if(bases, [](const std::string& base) { return !may_be_base(base); });
  return bases;
}

std::vector<std::string> forms_of(const std::string& base) {
  std::vector<std::string> forms{base};
  for (auto& form : past_forms(base)) forms.push_back(std::move(form));
  for (auto& form : ing_forms(base)) forms.push_back(std::move(form));
  return forms;
}

}  // namespace

bool are_forms_of_a_verb(std::string_view one, std::string_view other) {
  const bool irregular = std::ranges::any_of(
      irregular_verbs(), [&](const auto& verb) { return has(verb, one) && has(verb, other); });
  if (irregular) return true;
  if (is_irregular(one) || is_irregular(other)) return false;
  return std::ranges::any_of(possible_bases(one), [&](const std::string& base) {
    const auto forms = forms_of(base);
    return has(forms, one) && has(forms, other);
  });
}

}  // namespace bimodal::analysis
