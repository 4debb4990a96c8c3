#pragma once

#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "stimuli/audio/clip.hpp"
#include "synth/speech/score.hpp"

namespace bimodal::runner {

/// What is to be articulated, as the command line says it.
struct SpokenOptions {
  std::string text;                   ///< a text, a transcription, or the name of a score
  std::optional<std::string> method;  ///< of a text; absent: "dictionary"
  std::optional<std::string> from;    ///< absent: "text"
  std::optional<std::string> voice;   ///< of the method "festival"; absent: "kal"
  double rate = 1;
  std::string segments = "english";
};

/// Adds the positional argument and the options --method, --from, --voice, --rate, --segments.
void add_spoken_options(CLI::App& verb, SpokenOptions& options);

/// Adds --account: one of accounts() by its name, "dominance" by default.
void add_account_option(CLI::App& verb, std::string& account);

/// The inventory that the options choose: a file, or the name of one that ships. Throws Error
/// listing every mistake in it.
[[nodiscard]] synth::SegmentTable chosen_segments(const SpokenOptions& options);

/// The score of what the options say, at their rate: a file whose name ends with ".json" is read, a
/// text is said by the dictionary, by rules or by Festival, a transcription is taken as it is.
/// Tells on standard error which words the dictionary lacks. Throws Error if it cannot be said.
[[nodiscard]] synth::Score spoken_score(const SpokenOptions& options);

/// A score and the voice that says it.
struct VoicedScore {
  synth::Score score;
  Clip sound;  ///< as long as the score, but for rounding
};

/// As spoken_score, but Festival says and times it: a text as it reads it, a transcription phone by
/// phone. Throws Error also for what no voice says: a score, ambiguous sounds, durations of one's
/// own, phones read by another method.
[[nodiscard]] VoicedScore voiced_score(const SpokenOptions& options);

}  // namespace bimodal::runner
