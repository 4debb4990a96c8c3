#include "runner/cli/sound_check.hpp"

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

/// The trials of one condition that would clip, told together.
struct Clipping {
  int trials = 0;
  double lacking_db = 0.0;
  std::string worst_word;
};

Diagnostic describe_clipping(const std::string& file,
                             std::size_t condition,
                             const protocols::Protocol& protocol,
                             const Clipping& clipping) {
  const double lower = std::ceil(clipping.lacking_db * 10.0) / 10.0;
  return {
      .file = file,
      .pointer = fmt::format("/conditions/{}", condition),
      .finding = fmt::format("{} trials of condition \"{}\" would clip; the loudest, \"{}\", lacks "
                             "{:.1f} dB of headroom",
                             clipping.trials,
                             protocol.conditions.at(condition).name,
                             clipping.worst_word,
                             clipping.lacking_db),
      .remedy = fmt::format("lower /sound/speech_level_dbfs from {:g} to {:g} or less, or raise "
                            "snr_db",
                            protocol.sound.speech_level.count(),
                            protocol.sound.speech_level.count() - lower)};
}

}  // namespace

std::vector<Diagnostic> check_sounds(const protocols::Protocol& protocol,
                                     const std::vector<protocols::PlannedTrial>& plan,
                                     TrialPreparer& preparer,
                                     const std::string& file) {
  std::vector<Diagnostic> diagnostics;
  std::map<std::size_t, Clipping> clipped;
  for (const auto& trial : plan) {
    try {
      const auto mix = preparer.mix_sound(trial);
      const auto lacking = mix ? headroom_lacking(*mix) : std::nullopt;
      if (!lacking) continue;
      auto& clipping = clipped[trial.condition];
      ++clipping.trials;
      if (lacking->count() > clipping.lacking_db) {
        clipping.lacking_db = lacking->count();
        clipping.worst_word = trial.word.spelling;
      }
    } catch (const Error& error) {
      diagnostics.push_back(
          {.file = file,
           .pointer = fmt::format("/conditions/{}", trial.condition),
           .finding = fmt::format(
               "the word \"{}\" cannot be made: {}", trial.word.spelling, error.what())});
      if (diagnostics.size() >= 10) return diagnostics;  // a missing voice fails every word
    }
  }
  for (const auto& [condition, clipping] : clipped) {
    diagnostics.push_back(describe_clipping(file, condition, protocol, clipping));
  }
  return diagnostics;
}

}  // namespace bimodal::runner
