#pragma once

#include <string_view>
#include <vector>

#include "stimuli/words/dictionary.hpp"
#include "stimuli/words/letter_to_sound.hpp"
#include "stimuli/words/pronounced_word.hpp"

namespace bimodal {

/// How the words of a text are said, as the dictionary has it: each in its first pronunciation, or
/// in the one that the text chooses: "read(2)". A word with hyphens that the dictionary lacks is
/// said part by part, a number as number_words() says it ("1,000" is one number); any other that it
/// lacks by the letter-to-sound rules, which its `source` tells. Punctuation makes pauses. Throws
/// Error if plain_text() does, if a chosen pronunciation does not exist, or if letters and digits
/// are mixed in a word that the dictionary lacks ("3rd").
[[nodiscard]] std::vector<PronouncedWord> phones_by_dictionary(std::string_view text,
                                                               const Dictionary& dictionary,
                                                               const LetterToSound& rules);

/// How the words of a text are said by the letter-to-sound rules alone; digits one by one. Throws
/// Error if plain_text() does, if the text chooses pronunciations, of which the rules have one
/// each, or if the rules leave all of it silent ("h").
[[nodiscard]] std::vector<PronouncedWord> phones_by_rules(std::string_view text,
                                                          const LetterToSound& rules);

}  // namespace bimodal
