#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace bimodal {

/// How many letters must be inserted, deleted, replaced or exchanged with their neighbour to turn
/// one word into the other (optimal string alignment distance), in bytes.
[[nodiscard]] std::size_t edit_distance(std::string_view one, std::string_view other);

/// The known word that a mistyped one was probably meant to be: the one at the smallest edit
/// distance, the first of several; absent if it differs in more than a third of the typed letters
/// (two letters are always forgiven where the words share their first, and what follows "_" where
/// it was left out: "snr" for "snr_db"). Case does not count.
[[nodiscard]] std::optional<std::string_view> nearest(std::string_view typed,
                                                      std::span<const std::string_view> known);

}  // namespace bimodal
