#pragma once

#include <cstdint>
#include <string>

#include "stimuli/timeline/phone.hpp"

namespace bimodal {

/// What stands between a word and the next, from the weakest to the strongest. None is the end of a
/// word without a pause.
enum class Pause : std::uint8_t { None, Dash, Comma, Stop, Question };

enum class PhoneSource : std::uint8_t { Dictionary, Rules };

/// A word of a text and how it is said.
struct PronouncedWord {
  /// As it stands in the text; as the dictionary spells it ("read") if that is the source, so
  /// numbers as they are said ("twenty").
  std::string written;
  Pronunciation phones;  ///< empty if the letter-to-sound rules leave the word silent ("h")
  Pause after = Pause::None;
  PhoneSource source = PhoneSource::Dictionary;

  bool operator==(const PronouncedWord&) const = default;
};

}  // namespace bimodal
