#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "analysis/scoring/scoring_rules.hpp"

namespace bimodal::analysis {

/// The first rule, in the order of kTolerances, by which `rules` take `answer` for `word`. One rule
/// at a time: "stufs" is not taken for "stuff". Both are folded (fold_spelling) and different;
/// `is_a_word` says whether the dictionary has the answer. Every rule works both ways round.
///
/// Double letters: the two are the same when each run of a letter is written once, and the answer
/// is no word. Plural: one is the other with s, with es (after s, x, z, ch, sh, o), or with ies for
/// a y after a consonant. Tense: both are forms of a verb: the base, -ed, -d after e, -ing, with
/// the last consonant doubled, e dropped or y made i where spelling asks for it, or a row of the
/// table of irregular verbs; a base has three letters or more. What is no verb is not told from one
/// ("cars", "string"), only what is spelled as none. Contractions: a table; the contraction has its
/// apostrophe. Numbers: one is digits, the other how number_words() says them.
[[nodiscard]] std::optional<Tolerance> tolerated(std::string_view word,
                                                 std::string_view answer,
                                                 bool is_a_word,
                                                 const ScoringRules& rules);

/// Each rule on its own.
[[nodiscard]] bool differ_in_doubled_letters(std::string_view one, std::string_view other);
[[nodiscard]] bool differ_in_number(std::string_view one, std::string_view other);
[[nodiscard]] bool differ_in_tense(std::string_view one, std::string_view other);
[[nodiscard]] bool differ_in_contraction(std::string_view one, std::string_view other);

/// Whether a folded answer consists of digits.
[[nodiscard]] bool is_number(std::string_view folded);

/// A number as it is said, without spaces: "22" is "twentytwo".
[[nodiscard]] std::string said_number(std::string_view digits);

}  // namespace bimodal::analysis
