#include "runner/preparation/speech_bank.hpp"

#include <string_view>

#include <fmt/format.h>

#include "stimuli/audio/resample.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

const synth::SpokenItem& SpeechBank::item(const std::string& talker, const Word& word) {
  const std::lock_guard lock{mutex_};
  auto& kept = items_[{talker, word.spelling + ' ' + spell(word.phones)}];
  if (kept) return *kept;

  constexpr std::string_view kFestival = "festival:";
  if (!talker.starts_with(kFestival)) {
    throw Error{
        fmt::format("the auditory talker '{}' is not known; use 'festival:kal' or "
                    "'festival:slt'",
                    talker)};
  }
  auto voice = voices_.find(talker);
  if (voice == voices_.end()) {
    voice = voices_.emplace(talker, synth::Voice{talker.substr(kFestival.size())}).first;
  }
  auto spoken = voice->second.speak(word.spelling, word.phones);
  spoken.sound = resample(spoken.sound, rate_);
  kept = std::make_unique<synth::SpokenItem>(std::move(spoken));
  return *kept;
}

}  // namespace bimodal::runner
