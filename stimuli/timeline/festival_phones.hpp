#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "stimuli/timeline/phone.hpp"

namespace bimodal {

/// The symbol by which Festival's phone set "radio" names a phone, e.g. "uw". WH is spoken as "w":
/// the voices have no sound of its own for it.
[[nodiscard]] std::string_view festival_symbol(Phone phone);

/// The phones that a symbol of the phone set "radio" stands for: one; none if the symbol is
/// unknown; two for the syllabic consonants el em en (AX and the consonant). Its pauses are Rest,
/// the flap dx is D, axr is ER, hv is HH, nx is N.
[[nodiscard]] std::vector<Phone> phones_from_festival(std::string_view symbol);

/// Whether a voice that says `symbol` has said `asked`. That holds for the phone's own symbol and
/// for the reductions that English voices make: a vowel as ax, ER as axr, T or D as the flap dx,
/// HH as hv, N as nx.
[[nodiscard]] bool realises(std::string_view symbol, Phone asked);

}  // namespace bimodal
