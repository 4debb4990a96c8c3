#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "stimuli/video/frame_rate.hpp"

namespace bimodal {

/// Constant rate factor: how coarse pictures may be coded, the same for easy and hard ones; 0 is
/// the finest.
struct RateFactor {
  int usual = 0;
  int coarsest = 0;
};

/// A form in which video can be written.
struct VideoForm {
  std::string_view ending;           ///< of the file's name: ".mp4"
  std::string_view about;            ///< "H.264 and AAC"
  bool has_sound = false;            ///< whether it can have sound
  std::optional<RateFactor> factor;  ///< absent: it has no such choice
  /// 256 colours, and frames that last whole hundredths of a second.
  bool is_gif = false;
};

/// .mp4, .webm, .gif.
[[nodiscard]] std::span<const VideoForm> video_forms();

/// The form of a file by how its name ends, in any case; nullptr if it is none.
[[nodiscard]] const VideoForm* video_form_of(const std::filesystem::path& file);

/// How many frames a video of this form may have: those of a GIF, whose colours are chosen from all
/// of them, are kept until it is finished, in 1 GB at most.
[[nodiscard]] std::int64_t most_frames(const VideoForm& form,
                                       std::size_t width,
                                       std::size_t height);

/// The rate that a video of this form really has where `wanted` is asked for: itself, or the
/// nearest of which a frame lasts whole hundredths of a second, and at least two (programs slow
/// down what is faster).
[[nodiscard]] FrameRate rate_in(const VideoForm& form, const FrameRate& wanted);

}  // namespace bimodal
