#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "stimuli/base/quantity.hpp"

namespace bimodal {

/// What the picture of a media file is.
struct PictureTrack {
  std::size_t width = 0;  ///< pixels as shown: square, upright, after rotation
  std::size_t height = 0;
  std::size_t stored_width = 0;  ///< pixels as stored
  std::size_t stored_height = 0;
  Hertz frame_rate{};          ///< mean over the file, as its container tells
  bool variable_rate = false;  ///< frames do not follow each other at equal distances (measured)
  bool interlaced = false;
  int rotation_degrees = 0;  ///< clockwise, to be shown upright: 0, 90, 180, 270
  std::string codec;
  std::string pixel_format;
  Duration start{};   ///< of the first frame on the file's own clock
  Duration length{};  ///< to the end of the last frame
};

struct SoundTrack {
  int channels = 0;
  Hertz rate{};
  std::string codec;
  Duration start{};  ///< of the first sample on the file's own clock
  Duration length{};
};

/// A recording as FFmpeg sees it. Sound or picture may be absent, not both.
struct Media {
  std::string container;
  Duration length{};  ///< of the longer track, from the earlier start
  std::optional<PictureTrack> picture;
  std::optional<SoundTrack> sound;
};

/// Looks at a file of any format that FFmpeg reads, decoding its first frames (and, to find a
/// variable rate, reading the packets' times, no more than a minute of them). The file is not
/// trusted. Throws Error, naming the file, what was found and the remedy, if it is missing, empty,
/// no media file, damaged at its beginning, has neither sound nor picture, is longer than
/// kLongestMedia, or has a picture beyond kMostPicturePixels. Still pictures, playlists and texts
/// drawn as video are refused, covers are no picture; no other file than this one is opened. Of a
/// file that breaks off, what it holds counts; of one of more than a minute, the lengths are those
/// that it claims.
[[nodiscard]] Media examine_media(const std::filesystem::path& file);

inline constexpr Duration kLongestMedia = std::chrono::hours{4};
inline constexpr std::size_t kMostPicturePixels = std::size_t{8192} * 8192;

}  // namespace bimodal
