#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "stimuli/words/word_list.hpp"
#include "synth/voice/voice.hpp"

namespace bimodal::runner {

/// What the talkers of a protocol say: each item spoken once, at the session's sampling rate, and
/// kept. May be used by several threads.
class SpeechBank {
 public:
  explicit SpeechBank(Hertz rate) : rate_{rate} {}

  /// The word as `talker` ("festival:kal") says it. The reference stays valid as long as the bank.
  /// Throws Error for a talker or word that cannot be had.
  [[nodiscard]] const synth::SpokenItem& item(const std::string& talker, const Word& word);

 private:
  Hertz rate_;
  std::mutex mutex_;
  std::map<std::string, synth::Voice> voices_;
  std::map<std::pair<std::string, std::string>, std::unique_ptr<synth::SpokenItem>> items_;
};

}  // namespace bimodal::runner
