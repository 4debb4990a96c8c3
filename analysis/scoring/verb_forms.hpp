#pragma once

#include <string_view>

namespace bimodal::analysis {

/// Whether two spellings (lower case) may be forms of one verb: base, past, participle, -ing. A
/// table has the irregular verbs; of any other word it is taken for granted that it is a verb.
[[nodiscard]] bool are_forms_of_a_verb(std::string_view one, std::string_view other);

}  // namespace bimodal::analysis
