#pragma once

#include <span>
#include <vector>

#include "protocols/observers/phone_table.hpp"
#include "stimuli/timeline/segment.hpp"

namespace bimodal::protocols {

/// How likely each of a few answers is, where a listener must give one of them: Luce's choice over
/// the set (Luce 1959, Individual Choice Behavior), as Observer does over its candidate words. The
/// weight of an option is the product, over the positions, of P(its phone | the stimulus's phone),
/// each at least 1e-6, so that something is chosen where the table rules all of them out. An
/// option of another shape than the stimulus (other numbers or places of consonants and vowels, or
/// no phones) is not chosen as long as there is one of its shape; if there is none, all are as
/// likely. They sum to 1. `options` is not empty.
[[nodiscard]] std::vector<double> closed_set_probabilities(const Pronunciation& stimulus,
                                                           std::span<const Pronunciation> options,
                                                           const PhoneTable& confusions);

}  // namespace bimodal::protocols
