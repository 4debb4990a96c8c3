#pragma once

#include <string_view>
#include <vector>

#include "stimuli/timeline/phone.hpp"

namespace bimodal {

/// What a label in a tier of phones stands for.
struct PhoneName {
  enum class Kind {
    Unknown,  ///< no phone
    Phones,   ///< what `phones` says: one, or two that share its time by halves
    Closure,  ///< of a stop, or of an affricate, that follows; by itself the stop `phones`
    Glottal,  ///< a glottal stop, which English does not count as a phone
  };
  Kind kind = Kind::Unknown;
  std::vector<Phone> phones;
};

/// The meaning of a label in any case, with or without a stress digit: silence (see is_silence),
/// ARPAbet, Festival's phone set "radio", and the phone set of TIMIT (Garofolo et al. 1993, "TIMIT
/// acoustic-phonetic continuous speech corpus", table 4).
[[nodiscard]] PhoneName phone_name(std::string_view text);

/// Whether a phone can be the release of the closure that stands for the stop `stop`: a stop of the
/// same place, or an affricate after an alveolar closure.
[[nodiscard]] bool is_release(Phone stop, Phone phone);

}  // namespace bimodal
