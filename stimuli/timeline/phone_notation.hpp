#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/timeline/phone.hpp"

namespace bimodal {

/// How phones are written: ARPAbet as symbol() has it, the International Phonetic Alphabet (in
/// UTF-8, NFC), or its ASCII form X-SAMPA (Wells 1995).
enum class Notation : std::uint8_t { Arpabet, Ipa, XSampa };

/// One phone of General American: "ER", "ɝ", "3`". Rest is "rest" in ARPAbet and "|", the break, in
/// the other two. CH and JH have their tie bar in IPA.
[[nodiscard]] std::string_view written(Phone phone, Notation notation);

/// "S T UW", "stu", "stu". Where two phones would be read as one or otherwise ("T SH" as CH), IPA
/// and X-SAMPA have "." between them; so read_phones() always gives back the same phones.
[[nodiscard]] std::string write_phones(std::span<const Phone> phones, Notation notation);

/// The phones that somebody wrote. ARPAbet: symbols with blanks between them, in any case, with or
/// without stress digits. IPA and X-SAMPA: the longest symbol that fits wins, so "tʃ" is CH and
/// "t.ʃ" is T SH; marks of stress, length and syllables, tie bars, blanks, slashes and brackets are
/// passed over. Other symbols of the same sounds are understood as well: ɚ and ɜ for ɝ, r for ɹ, g
/// for ɡ, ɒ for ɑ, əʊ for oʊ, ɾ for D, ligatures. A lone "e", "o" or "a" is none: it means
/// different vowels to different writers. Throws Error, naming the symbol that is not known, its
/// place and what is near, or that there are no phones.
[[nodiscard]] std::vector<Phone> read_phones(std::string_view text, Notation notation);

}  // namespace bimodal
