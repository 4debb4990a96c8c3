#pragma once

#include <vector>

#include "stimuli/base/quantity.hpp"
#include "stimuli/timeline/phone.hpp"

namespace bimodal {

/// One phone and when it sounds, counted from the start of the recording.
struct TimedPhone {
  Phone phone = Phone::Rest;
  Duration start{};
  Duration duration{};

  [[nodiscard]] Duration end() const { return start + duration; }

  bool operator==(const TimedPhone&) const = default;
};

/// What is said, when: phones in order, without gaps or overlap, usually with rest at both ends.
struct Utterance {
  std::vector<TimedPhone> phones;

  [[nodiscard]] Duration end() const { return phones.empty() ? Duration{} : phones.back().end(); }

  bool operator==(const Utterance&) const = default;
};

/// From the start of the first phone that is not rest to the end of the last one.
struct SpeechInterval {
  Duration start{};
  Duration end{};

  bool operator==(const SpeechInterval&) const = default;
};

/// Empty (start == end) if the utterance is all rest.
[[nodiscard]] SpeechInterval speech_interval(const Utterance& utterance);

}  // namespace bimodal
