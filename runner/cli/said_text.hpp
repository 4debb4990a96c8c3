#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stimuli/timeline/phone_notation.hpp"
#include "stimuli/words/pronounced_word.hpp"

namespace bimodal::runner {

/// "arpabet", "ipa", "xsampa".
[[nodiscard]] Notation notation_named(std::string_view name);

/// The words of a text as the method "nrl" or "dictionary" says them. Tells on standard error which
/// words the dictionary lacks. Throws Error if the text cannot be said.
[[nodiscard]] std::vector<PronouncedWord> said_words(const std::string& text,
                                                     std::string_view method);

/// Tells on standard error which words the dictionary lacks.
void tell_doubts(const std::vector<PronouncedWord>& words);

/// All phones, with rest where words have a pause between them.
[[nodiscard]] std::vector<Phone> joined(const std::vector<PronouncedWord>& words);

}  // namespace bimodal::runner
