#include "runner/cli/sound_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/json_lines.hpp"

namespace bimodal::runner {

namespace {

/// The trials of one condition that would clip, or could, told together.
struct Clipping {
  int trials = 0;
  double lacking_db = 0.0;           ///< of the worst
  double possibly_lacking_db = 0.0;  ///< of the worst, with any noise
  std::string worst_word;
};

void note(Clipping& clipping, const std::string& word, const Mix& mix) {
  const double possibly = decibels(highest_peak(mix)).count();
  if (possibly > clipping.possibly_lacking_db) {
    clipping.possibly_lacking_db = possibly;
    if (clipping.trials == 0) clipping.worst_word = word;
  }
  const auto lacking = headroom_lacking(mix);
  if (!lacking) return;
  ++clipping.trials;
  if (lacking->count() > clipping.lacking_db) {
    clipping.lacking_db = lacking->count();
    clipping.worst_word = word;
  }
}

std::string remedy_for(const Clipping& clipping, const protocols::Sound& sound) {
  const double lower =
      std::ceil(std::max(clipping.lacking_db, clipping.possibly_lacking_db) * 10.0) / 10.0;
  if (sound.speech_spl) {
    return fmt::format(
        "lower /sound/speech_level_dbspl from {0:g} to {1:g} or less, or raise snr_db, or turn the "
        "amplifier up by {2:g} dB and measure again",
        sound.speech_spl->count(),
        sound.speech_spl->count() - lower,
        lower);
  }
  return fmt::format("lower /sound/speech_level_dbfs from {:g} to {:g} or less, or raise snr_db",
                     sound.speech_level.count(),
                     sound.speech_level.count() - lower);
}

std::string finding_of(const Clipping& clipping, const std::string& condition) {
  if (clipping.trials == 0) {
    return fmt::format(
        "no sound of condition \"{}\" clips here, but with the noise of another participant \"{}\" "
        "could: it would need {:.1f} dB more headroom to be sure",
        condition,
        clipping.worst_word,
        clipping.possibly_lacking_db);
  }
  return fmt::format(
      "{} {} of condition \"{}\" would clip; the loudest, \"{}\", lacks {:.1f} dB of headroom",
      clipping.trials,
      clipping.trials == 1 ? "sound" : "sounds",
      condition,
      clipping.worst_word,
      clipping.lacking_db);
}

}  // namespace

std::vector<protocols::PlannedTrial> every_stimulus(const protocols::ReadProtocol& read) {
  std::vector<protocols::PlannedTrial> stimuli;
  for (std::size_t condition = 0; condition < read.protocol.conditions.size(); ++condition) {
    for (const auto* words : {&read.practice, &read.words.words}) {
      for (const auto& word : *words) {
        stimuli.push_back({.index = stimuli.size(),
                           .word = word,
                           .condition = condition,
                           .noise_seed = read.protocol.seed + stimuli.size()});
      }
    }
  }
  return stimuli;
}

std::vector<Diagnostic> check_sounds(const protocols::ReadProtocol& read,
                                     const std::vector<protocols::PlannedTrial>& plan,
                                     TrialPreparer& preparer,
                                     const std::string& file) {
  const auto& protocol = read.protocol;
  const JsonLines lines{read.text};
  std::vector<Diagnostic> diagnostics;
  const auto find = [&](Severity severity, std::size_t condition, std::string finding) {
    const auto pointer = read.condition_pointers.at(condition);
    diagnostics.push_back({.severity = severity,
                           .file = file,
                           .line = lines.line_of(pointer),
                           .pointer = pointer,
                           .finding = std::move(finding)});
  };
  std::map<std::size_t, Clipping> clippings;
  for (const auto& trial : plan) {
    try {
      if (const auto mix = preparer.mix_sound(trial)) {
        note(clippings[trial.condition], shown_name(trial.word), *mix);
      }
    } catch (const Error& error) {
      find(Severity::Error,
           trial.condition,
           fmt::format("the word \"{}\" cannot be made: {}", shown_name(trial.word), error.what()));
      if (diagnostics.size() >= 10) return diagnostics;  // a missing voice fails every word
    }
  }
  for (const auto& [condition, clipping] : clippings) {
    if (clipping.trials == 0 && clipping.possibly_lacking_db <= 0.0) continue;
    find(clipping.trials > 0 ? Severity::Error : Severity::Warning,
         condition,
         finding_of(clipping, protocol.conditions.at(condition).name));
    diagnostics.back().remedy = remedy_for(clipping, protocol.sound);
  }
  return diagnostics;
}

}  // namespace bimodal::runner
