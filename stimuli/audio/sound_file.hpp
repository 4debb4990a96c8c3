#pragma once

#include <filesystem>

#include "stimuli/audio/clip.hpp"

namespace bimodal {

/// What to do with a file of several channels.
enum class Channels {
  One,      ///< refuse it
  MixDown,  ///< take the mean of all channels
};

/// Reads a WAV or FLAC file (libsndfile). The file is not trusted: throws Error, naming the file,
/// what was found and the remedy, if it is of another kind, has no samples or more than an hour,
/// has a rate outside 4 to 384 kHz, ends before its header says, or holds a sample that is not a
/// finite number, or has several channels and `channels` is One. Samples beyond full scale, which
/// floating-point files can hold, are kept.
[[nodiscard]] Clip read_sound(const std::filesystem::path& file, Channels channels = Channels::One);

enum class SampleFormat {
  Float32,  ///< the very samples
  Pcm24,    ///< rounded to 24-bit integers, for programs that cannot read floats
};

/// Writes a WAV file of one channel; the same sound gives the same bytes. Atomic: it is written
/// beside `file` under another name, then renamed, so that `file` is never half there. Throws Error
/// if it cannot be written, if the rate is not a whole number, if a sample is not finite, or, in
/// Pcm24, if one is beyond full scale.
void write_wav(const std::filesystem::path& file,
               const Clip& sound,
               SampleFormat format = SampleFormat::Float32);

}  // namespace bimodal
