#include "runner/cli/said_text.hpp"

#include <fmt/format.h>

#include "stimuli/words/dictionary.hpp"
#include "stimuli/words/letter_to_sound.hpp"
#include "stimuli/words/text_phones.hpp"

namespace bimodal::runner {

Notation notation_named(std::string_view name) {
  if (name == "ipa") return Notation::Ipa;
  if (name == "xsampa") return Notation::XSampa;
  return Notation::Arpabet;
}

void tell_doubts(const std::vector<PronouncedWord>& words) {
  for (const auto& word : words) {
    if (word.source == PhoneSource::Rules) {
      fmt::print(stderr,
                 "bimodal: \"{}\" is not in the dictionary; by the letter-to-sound rules: {}\n",
                 word.written,
                 word.phones.empty() ? "silent" : spell(word.phones));
    }
  }
}

std::vector<PronouncedWord> said_words(const std::string& text, std::string_view method) {
  const auto rules = LetterToSound::shipped();
  if (method == "nrl") return phones_by_rules(text, rules);
  auto words = phones_by_dictionary(text, Dictionary{Dictionary::installed()}, rules);
  tell_doubts(words);
  return words;
}

std::vector<Phone> joined(const std::vector<PronouncedWord>& words) {
  std::vector<Phone> phones;
  for (const auto& word : words) {
    phones.insert(phones.end(), word.phones.begin(), word.phones.end());
    if (word.after != Pause::None && &word != &words.back()) phones.push_back(Phone::Rest);
  }
  return phones;
}

}  // namespace bimodal::runner
