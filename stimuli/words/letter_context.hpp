#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace bimodal {

// The contexts of letter-to-sound rules (Elovitz et al. 1976): letters, blanks and apostrophes that
// stand for themselves, and the symbols
//
//   #  one or more vowels (A E I O U Y)       .  a voiced consonant (B D V G J L M N R W Z)
//   *  one or more consonants                 +  a front vowel: E, I or Y
//   :  no, one or more consonants             &  a sibilant: S C G Z X J CH SH
//   ^  one consonant                          @  T S R D L Z N J TH CH SH: U after it is long
//   $  a consonant and then E or I            %  a suffix: E ER ES ED ING and the end of the word
//
// A context matches if there is any way at all in which its symbols can share the letters out
// between them (backtracking).

/// Whether contexts may have this: a capital letter, blank, apostrophe or symbol.
[[nodiscard]] bool is_of_context(char symbol);

/// A context made ready for matching: its symbols in the order in which they lie outwards from the
/// letters that a rule reads. Precondition: is_of_context() of every one.
[[nodiscard]] std::string context_before(std::string_view context);
[[nodiscard]] std::string context_after(std::string_view context);

/// Whether the text that ends before `at` ends with the context. Precondition: capitals.
[[nodiscard]] bool stands_before(std::string_view ready_context,
                                 std::string_view text,
                                 std::size_t at);

/// Whether the text that begins at `at` begins with the context. Precondition: capitals.
[[nodiscard]] bool stands_after(std::string_view ready_context,
                                std::string_view text,
                                std::size_t at);

}  // namespace bimodal
