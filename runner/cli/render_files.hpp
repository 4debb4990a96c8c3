#pragma once

#include <optional>

#include "runner/cli/render_output.hpp"
#include "runner/cli/seen_speech.hpp"
#include "stimuli/video/frame_rate.hpp"
#include "synth/face/head.hpp"
#include "synth/render/appearance.hpp"
#include "synth/render/view.hpp"

namespace bimodal::runner {

/// How what is seen becomes pictures.
struct RenderStyle {
  synth::View view;
  synth::Appearance appearance;
  FrameRate rate;
  std::optional<int> rate_factor;       ///< of films; absent: the usual one
  std::optional<Milliseconds> instant;  ///< of a still
};

/// Draws into one output and says on standard output what it wrote; tells on standard error how far
/// it has come, if that is a terminal. `sound` is what films get that can have sound; nullptr:
/// none. Ctrl-C leaves nothing half-written. Throws Error if something cannot be drawn or written.
void write_rendered(const RenderOutput& output,
                    const SeenSpeech& seen,
                    const Clip* sound,
                    const synth::Head& head,
                    const RenderStyle& style);

}  // namespace bimodal::runner
