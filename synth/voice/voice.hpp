#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/audio/clip.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal::synth {

/// A spoken item: its sound and when each phone sounds in it.
struct SpokenItem {
  Clip sound;
  Utterance utterance;  ///< begins and ends with rest; ends where the sound ends
};

/// Festival, which speaks with one of its installed voices. Festival is one interpreter per process
/// and not thread-safe: all instances share it behind a lock.
class Voice {
 public:
  /// `name` is a Festival voice without its suffix: "kal" or "slt". Throws Error naming the Debian
  /// package to install if Festival or the voice is absent.
  explicit Voice(std::string_view name);

  /// The names this machine has, of those the project supports.
  [[nodiscard]] static std::vector<std::string> installed();

  /// Speaks one word. With a pronunciation it is spoken exactly so; without, Festival's lexicon and
  /// letter-to-sound rules decide. `word` is data: it never reaches Festival as Scheme source.
  /// Throws Error if Festival produces no sound.
  [[nodiscard]] SpokenItem speak(std::string_view word,
                                 std::span<const Phone> pronunciation = {}) const;

  /// "festival:kal", with Festival's and the voice's version where known.
  [[nodiscard]] std::string description() const;

 private:
  std::string name_;
};

}  // namespace bimodal::synth
