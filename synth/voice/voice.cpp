#include "synth/voice/voice.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "stimuli/timeline/festival_phones.hpp"
#include "synth/voice/festival.hpp"
#include "synth/voice/spoken_item.hpp"

namespace bimodal::synth {

namespace {

struct Supported {
  std::string_view name;
  std::string_view procedure;  ///< what selects it in Festival
  std::string_view package;    ///< what installs it on Debian
  std::string_view note;       ///< how it differs from Festival's own; empty if it does not
};

constexpr std::array<Supported, 2> kVoices{{
    {"kal", "voice_kal_diphone", "festvox-kallpc16k", ", AH by its own diphones"},
    {"slt", "voice_cmu_us_slt_arctic_hts", "festvox-us-slt-hts", ""},
}};

const Supported& supported(std::string_view name) {
  const auto* const found = std::ranges::find(kVoices, name, &Supported::name);
  if (found != kVoices.end()) return *found;
  throw Error{fmt::format("there is no voice '{}'; the voices are kal and slt", name)};
}

/// Festival knows ASCII only and drops the rest in silence ("café" would be said "caf").
void must_be_speakable(std::string_view word) {
  const auto is_printable = [](char c) { return c >= ' ' && c <= '~'; };
  const auto is_read = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  if (std::ranges::all_of(word, is_printable) && std::ranges::any_of(word, is_read)) return;
  throw Error{
      fmt::format("Festival cannot read '{}', which is not a word in ASCII letters; give its"
                  " pronunciation",
                  word)};
}

}  // namespace

Voice::Voice(std::string_view name) : name_{name} {
  const auto& voice = supported(name);
  if (!Festival::shared().has_voice(voice.procedure)) {
    throw Error{fmt::format("Festival's voice '{}' is not installed; install the Debian package {}",
                            name,
                            voice.package)};
  }
}

std::vector<std::string> Voice::installed() {
  std::vector<std::string> names;
  try {
    for (const auto& voice : kVoices) {
      if (Festival::shared().has_voice(voice.procedure)) names.emplace_back(voice.name);
    }
  } catch (const Error&) {
    return {};  // without Festival there are no voices
  }
  return names;
}

SpokenItem Voice::speak(std::string_view word, std::span<const Phone> pronunciation) const {
  const auto procedure = supported(name_).procedure;
  auto& festival = Festival::shared();
  try {
    if (pronunciation.empty()) {
      must_be_speakable(word);
      return spoken_item(festival.speak_text(procedure, word), {});
    }
    if (std::ranges::find(pronunciation, Phone::Rest) != pronunciation.end()) {
      throw Error{fmt::format("the pronunciation '{}' contains rest", spell(pronunciation))};
    }
    std::vector<std::string_view> symbols;
    for (const Phone phone : pronunciation) symbols.push_back(festival_symbol(phone));
    return spoken_item(festival.speak_phones(procedure, symbols), pronunciation);
  } catch (const Error&) {
    std::throw_with_nested(Error{fmt::format("cannot speak the word '{}'", word)});
  }
}

std::string Voice::description() const {
  return fmt::format("festival:{} (Festival {}, {}{})",
                     name_,
                     Festival::shared().version(),
                     supported(name_).procedure,
                     supported(name_).note);
}

}  // namespace bimodal::synth
