#pragma once

#include <span>

#include "protocols/observers/observer.hpp"

namespace bimodal::protocols {

/// Expected numbers of answers, by stimulus and response phone: what an analysis of one
/// presentation of each word should find on the average.
struct ImpliedConfusions {
  PhoneTable initial;  ///< first consonant, of words that begin with one
  PhoneTable vowel;    ///< of words with one vowel
  PhoneTable final;    ///< last consonant, of words that end with one
  double correct = 0;  ///< answers that sound like their stimulus
};

/// By enumeration of every answer to every stimulus, without sampling.
[[nodiscard]] ImpliedConfusions implied_confusions(const Observer& observer,
                                                   std::span<const Word> stimuli,
                                                   const Presented& presented);

}  // namespace bimodal::protocols
