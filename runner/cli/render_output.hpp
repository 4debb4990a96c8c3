#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "stimuli/video/video_form.hpp"

namespace bimodal::runner {

/// What a name that pictures or sound are to be written to stands for.
struct RenderOutput {
  enum class Kind {
    Film,    ///< .mp4, .webm, .gif
    Strip,   ///< .png: one picture at the centre of each segment
    Still,   ///< .png with an instant: one picture
    Frames,  ///< a folder, or a name with %04d: one PNG a frame
    Sound,   ///< .wav
  };

  Kind kind = Kind::Film;
  std::string name;                 ///< as it was given
  const VideoForm* form = nullptr;  ///< of a film

  /// Of frame `number`, from 0.
  [[nodiscard]] std::filesystem::path frame_file(std::int64_t number) const;

  /// Whether it is a film that can have sound.
  [[nodiscard]] bool has_sound() const { return form != nullptr && form->has_sound; }
};

/// Judges by the name alone, and whether there is a folder of this name. Throws Error if it is none
/// of these.
[[nodiscard]] RenderOutput render_output(const std::string& name, bool has_instant);

/// Makes the folder of frames; throws Error if it cannot be, or nothing can be written there.
void require_place_for(const RenderOutput& output);

}  // namespace bimodal::runner
