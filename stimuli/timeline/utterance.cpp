#include "stimuli/timeline/utterance.hpp"

#include <algorithm>

namespace bimodal {

SpeechInterval speech_interval(const Utterance& utterance) {
  const auto sounds = [](const TimedPhone& timed) { return timed.phone != Phone::Rest; };
  const auto& phones = utterance.phones;
  const auto first = std::ranges::find_if(phones, sounds);
  if (first == phones.end()) return {};
  const auto last = std::find_if(phones.rbegin(), phones.rend(), sounds);
  return {.start = first->start, .end = last->end()};
}

}  // namespace bimodal
