#pragma once

#include <cstdint>

#include "stimuli/audio/clip.hpp"
#include "stimuli/video/container_writer.hpp"

namespace bimodal::libav {

/// The track of sound of a file that is being written: one channel of 48 kHz. AAC and Opus overlap
/// their blocks, so that what a decoder gives begins some samples (1024, 312) before the sound: the
/// file says so (an edit list in MP4, a codec delay in WebM) and players leave them out.
class SoundEncoder {
 public:
  /// `encoder` by FFmpeg's name ("aac", "libopus"), `bits` a second. `sound` is brought to 48 kHz.
  SoundEncoder(ContainerWriter& container,
               const char* encoder,
               std::int64_t bits,
               const Clip& sound);

  /// Encodes what begins before `time`.
  void encode_until(Milliseconds time);

  void finish();

 private:
  void encode_block();

  ContainerWriter& container_;
  EncodedTrack track_;
  Clip sound_;
  std::size_t done_ = 0;  ///< samples
  Frame frame_ = new_frame();
};

}  // namespace bimodal::libav
