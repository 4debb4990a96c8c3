#pragma once

#include <map>
#include <string>

#include "protocols/model/protocol.hpp"
#include "stimuli/base/quantity.hpp"
#include "stimuli/corpus/corpus.hpp"

namespace bimodal::runner {

/// To which line of the screen a session's visual onsets refer.
struct VisualLineReference {
  std::string name = "first";  ///< "first", "mouth", as stored
  Duration after{};            ///< how long after the first line it is drawn
};

/// Where a picture is: in the middle of the window, both in pixels.
struct PicturePlace {
  int window_height = 0;
  int picture_height = 0;
};

/// The height in the window of what is at `part` of the picture's height: a part of the window's
/// height, from its top.
[[nodiscard]] double height_in_window(const PicturePlace& place, double part);

/// When the line at this part of the screen's height is drawn, after the first one: the same part
/// of the refresh period. Screens draw their lines downwards at an even pace; the pause after the
/// last line, usually 2 to 6 % of the period, counts as lines here, so that the mouth is stated up
/// to 0.6 ms late at 60 Hz.
[[nodiscard]] Duration drawn_after(double part, Duration period);

/// Where the mouth is in the pictures of a condition: of the synthetic face that of its resting
/// lips in its view, of a recorded talker two thirds of the height, as is usual where a face fills
/// a picture. A part of the picture's height, from its top.
[[nodiscard]] double mouth_height(const protocols::Condition& condition);

/// What the protocol's "visual_line" comes to on a screen whose whole height is the window's. Where
/// conditions have their mouths at different heights, the mean of these, for a session has one
/// reference; "first" where nobody is seen. Throws Error if a recording cannot be read.
[[nodiscard]] VisualLineReference visual_line_of(const protocols::Protocol& protocol,
                                                 const std::map<std::string, Corpus>& corpora,
                                                 int window_height,
                                                 Duration period);

}  // namespace bimodal::runner
