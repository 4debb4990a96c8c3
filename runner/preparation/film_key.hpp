#pragma once

#include <optional>
#include <span>
#include <string>

#include "runner/preparation/frame_source.hpp"
#include "runner/preparation/shown_look.hpp"
#include "runner/session/cue_sheet.hpp"
#include "stimuli/timeline/account.hpp"
#include "stimuli/timeline/segment.hpp"
#include "synth/render/quality.hpp"

namespace bimodal::runner {

/// Everything that a film of the face depends on.
struct FilmOrigin {
  std::string drawing;  ///< see drawing_identity()
  std::span<const TimedSegment> articulation;
  std::string table_sha256;  ///< of the inventory
  Account account = Account::Dominance;
  ShownLook look;
  synth::Quality quality = synth::Quality::Fast;
  StimulusLayout layout;
  Hertz drawing_rate;
  std::optional<Cut> cut;
};

/// What draws: this very program, the head and the shaders that it ships with, and the machine's
/// OpenGL. Hence a film is never taken for one that another version would draw. Throws Error as
/// opengl_description().
[[nodiscard]] std::string drawing_identity();

/// A name for the film: 64 hexadecimal digits, others if anything differs.
[[nodiscard]] std::string film_key(const FilmOrigin& origin);

}  // namespace bimodal::runner
