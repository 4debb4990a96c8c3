#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "runner/cli/spoken_score.hpp"
#include "stimuli/audio/clip.hpp"
#include "stimuli/timeline/account.hpp"
#include "synth/speech/control.hpp"
#include "synth/speech/expression.hpp"

namespace bimodal::runner {

/// An instant with the name of the segment in whose centre it lies.
struct NamedInstant {
  std::string symbol;
  Milliseconds time{};
};

/// What the face is to do from time 0 on, and what is heard with it.
struct SeenSpeech {
  std::function<synth::Pose(Milliseconds)> pose;  ///< defined for all times
  Milliseconds end{};
  std::vector<NamedInstant> centres;  ///< of the segments; empty if they are not known
  std::optional<Clip> sound;          ///< of the voice that says it
};

/// A text, transcription or score as the face articulates it; `voiced`: and as Festival says it.
/// Throws Error as spoken_score() and voiced_score().
[[nodiscard]] SeenSpeech articulated_speech(const SpokenOptions& options,
                                            Account account,
                                            bool voiced);

/// Whether a file is a table of tracks (.csv), or JSON with sampled tracks: not a score alone.
[[nodiscard]] bool names_tracks(const std::string& file);

/// Tracks as `bimodal tracks` writes them, by straight lines between their instants; before the
/// first and after the last the face stands still. Controls that are not there are neutral. Tells
/// on standard error which columns are no controls of the face, and which controls leave its range
/// (contacts may, upwards). Throws Error listing what is wrong: columns, numbers, times.
[[nodiscard]] SeenSpeech tracked_speech(const std::string& file);

/// The same with expressions on top.
[[nodiscard]] SeenSpeech with_expressions(SeenSpeech seen,
                                          std::vector<synth::ShownExpression> shown);

}  // namespace bimodal::runner
