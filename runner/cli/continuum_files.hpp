#pragma once

#include <filesystem>

#include "runner/cli/face_view.hpp"
#include "stimuli/video/frame_rate.hpp"
#include "synth/face/head.hpp"
#include "synth/inspection/worked_continuum.hpp"

namespace bimodal::runner {

/// Removes what an earlier continuum left in the folder and this one may not write: token0.csv ...,
/// token0.mp4 ..., tokens.json. Leaves a folder alone that has no tokens.csv, so none of ours.
void remove_earlier_tokens(const std::filesystem::path& folder);

/// tokens.csv: a row per token with its name, its place, the lips' measures in the middle, how long
/// they are shut, how soon half open, how fast, and every control in the middle.
void write_token_table(const synth::Continuum& continuum, const std::filesystem::path& folder);

/// tokens.json: the tokens between two sounds as a word list for protocols, each under its name in
/// lower case. False if the context has rests, which words have not.
[[nodiscard]] bool write_token_words(const synth::Continuum& continuum,
                                     const std::filesystem::path& folder);

/// token0.csv ...: every control at 1000 Hz.
void write_token_tracks(const synth::Continuum& continuum, const std::filesystem::path& folder);

/// strip.png: the tokens side by side: whole face and mouth in the middle, and the mouth at
/// synth::kReleased.
void write_token_strip(const synth::Continuum& continuum,
                       const synth::Head& head,
                       const ViewOptions& view,
                       const std::filesystem::path& folder);

/// token0.mp4 ...: silent videos. Tells on standard error how far it has come.
void write_token_videos(const synth::Continuum& continuum,
                        const synth::Head& head,
                        const ViewOptions& view,
                        const FrameRate& rate,
                        const std::filesystem::path& folder);

}  // namespace bimodal::runner
