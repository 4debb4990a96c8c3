#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "protocols/model/protocol.hpp"
#include "runner/preparation/frame_source.hpp"
#include "stimuli/corpus/corpus.hpp"

namespace bimodal::runner {

/// A look with everything decided.
struct ShownLook {
  std::size_t height = 0;           ///< pixels on the screen
  std::size_t lines = 0;            ///< with so many lines it is drawn, then enlarged or reduced
  std::optional<Hertz> frame_rate;  ///< the picture changes no more often
  double blur_px = 0.0;             ///< standard deviation, pixels on the screen
  std::uint32_t background = 0;     ///< behind the synthetic face
  protocols::Face face;             ///< of the synthetic face; default for others

  auto operator<=>(const ShownLook&) const = default;
};

/// What the picture of a talker is by nature: what a look "like" somebody is taken from.
struct PictureNature {
  double frame_rate_hz = 0.0;          ///< 0: as often as the display refreshes
  std::size_t lines = 0;               ///< 0: as many as are asked for
  std::optional<double> eye_distance;  ///< outer eye corners, in parts of the picture's height
  std::optional<std::uint32_t> background;
};

/// The nature of "face" or "corpus:NAME", judged by the first item's recording: background is the
/// mean of the upper corners of its first frame. Throws Error if the recording cannot be read or
/// has no picture.
[[nodiscard]] PictureNature nature_of(const std::string& talker,
                                      const std::map<std::string, Corpus>& corpora);

/// Decides a condition's look: its own keys first, then those of the talker that it is to be like,
/// then the window's. To be like somebody means: no higher frame rate, no finer lines on the
/// screen, the same distance of the eyes on the screen (where both are known, else the same height
/// of the picture), and, for the synthetic face, the same background.
[[nodiscard]] ShownLook decide_look(const protocols::Condition& condition,
                                    const protocols::Window& window,
                                    const std::map<std::string, Corpus>& corpora);

/// The frames of `source`, changed no more often than the look's frame rate, at its height, and
/// blurred.
[[nodiscard]] std::unique_ptr<FrameSource> with_look(std::unique_ptr<FrameSource> source,
                                                     const ShownLook& look);

}  // namespace bimodal::runner
