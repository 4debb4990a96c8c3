#pragma once

// What tests of corpora share: a folder of their own, and a synthetic talker.

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "stimuli/audio/clip.hpp"
#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/random.hpp"
#include "stimuli/timeline/utterance.hpp"
#include "synth/voice/voice.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::testing_corpus {

/// A reading put together: silence of a room at -70 dB FS, words, noises.
class Reading {
 public:
  explicit Reading(const synth::Voice& voice, Seed seed = 1) : voice_{&voice}, random_{seed} {}

  Reading& pause(double seconds) {
    const auto count = static_cast<std::size_t>(seconds * rate());
    clip_.samples.insert(clip_.samples.end(), count, 0.0F);
    return *this;
  }

  /// Says a word and returns when its first phone begins and its last one ends.
  SpeechInterval say(const std::string& word, std::span<const Phone> phones = {}, float gain = 1) {
    const auto item = voice_->speak(word, phones);
    clip_.rate = item.sound.rate;
    const auto at = clip_.duration();
    for (const float sample : item.sound.samples) clip_.samples.push_back(gain * sample);
    const auto speech = speech_interval(item.utterance);
    return {at + speech.start, at + speech.end};
  }

  /// A burst of noise.
  SpeechInterval cough(double seconds) {
    const auto start = clip_.duration();
    const auto count = static_cast<std::size_t>(seconds * rate());
    for (std::size_t n = 0; n < count; ++n) {
      clip_.samples.push_back(static_cast<float>(0.08 * random_.normal()));
    }
    return {start, clip_.duration()};
  }

  [[nodiscard]] Clip sound() {
    auto whole = clip_;
    for (auto& sample : whole.samples) {
      sample += static_cast<float>(3e-4 * random_.normal());
      sample = std::clamp(sample, -1.0F, 1.0F);
    }
    return whole;
  }

 private:
  [[nodiscard]] double rate() const { return clip_.rate.count(); }

  const synth::Voice* voice_;
  Clip clip_{Hertz{16'000}, {}};
  Random random_;
};

/// The folder of test data; absent if there is none.
inline std::filesystem::path test_data() {
  const char* const named = std::getenv("BIMODAL_TEST_DATA");
  return named == nullptr ? std::filesystem::path{} : std::filesystem::path{named};
}

}  // namespace bimodal::testing_corpus
