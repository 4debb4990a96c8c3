#pragma once

#include <cstddef>
#include <filesystem>
#include <list>
#include <map>

#include "stimuli/audio/clip.hpp"
#include "stimuli/video/media_file.hpp"
#include "stimuli/video/sound_track.hpp"

namespace bimodal {

/// Reads stretches of sound tracks as read_sound_track does, to the same samples, and keeps the
/// tracks that were read last: many words out of one long recording cost one decoding. Files must
/// not change meanwhile.
class KeptTracks {
 public:
  /// Up to so many samples are kept (64 million: 256 MB, 22 minutes at 48 kHz); a longer track is
  /// decoded for each of its stretches.
  explicit KeptTracks(std::size_t most_samples = 64'000'000) : most_samples_{most_samples} {}

  /// Whether there is a sound track at all. Throws Error as examine_media does.
  [[nodiscard]] bool has_sound(const std::filesystem::path& file) {
    return media_of(file).sound.has_value();
  }

  /// Throws Error as read_sound_track does.
  [[nodiscard]] Clip read(const std::filesystem::path& file, Hertz rate, MediaSpan span);

  /// How often a track was decoded whole.
  [[nodiscard]] std::size_t decoded() const { return decoded_; }

 private:
  struct Track {
    std::filesystem::path file;
    Clip sound;
  };

  const Media& media_of(const std::filesystem::path& file);

  /// Null if the file's track is too long to be kept.
  const Clip* track_of(const std::filesystem::path& file);

  std::size_t most_samples_;
  std::size_t decoded_ = 0;
  std::map<std::filesystem::path, Media> media_;
  std::list<Track> tracks_;  ///< the one used last first
};

}  // namespace bimodal
