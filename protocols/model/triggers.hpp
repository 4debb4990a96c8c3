#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "stimuli/base/quantity.hpp"

namespace bimodal::protocols {

/// What other equipment can be told of.
enum class TriggerEvent {
  TrialStart,    ///< the fixation mark has appeared
  VisualZero,    ///< the recording's time zero is seen
  AuditoryZero,  ///< the recording's time zero is heard
  StimulusEnd,   ///< nothing is seen or heard any more
  Response,      ///< the answer has been given
};

/// As protocols and data files write them, in the order of TriggerEvent.
inline constexpr std::array<std::string_view, 5> kTriggerEvents{
    "trial_start", "visual_zero", "auditory_zero", "stimulus_end", "response"};

[[nodiscard]] constexpr std::string_view name(TriggerEvent event) {
  return kTriggerEvents[static_cast<std::size_t>(event)];
}

enum class Corner { UpperLeft, UpperRight, LowerLeft, LowerRight };

/// Of a patch: at time zero, and at all other times.
enum class Polarity { WhiteOnBlack, BlackOnWhite };

/// A part of the window, in its pixels.
struct PixelBox {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
};

/// A square patch on the screen for a photodiode.
struct Photodiode {
  Corner corner = Corner::UpperLeft;
  /// Where its middle is instead, as parts of the window's width (from the left) and height (from
  /// the top).
  std::optional<std::array<double, 2>> centre;
  int size = 60;  ///< pixels, both ways
  Polarity polarity = Polarity::WhiteOnBlack;
  Duration length = std::chrono::milliseconds{100};  ///< of the colour of time zero
};

/// Where the patch lies in a window of so many pixels; it may reach beyond it.
[[nodiscard]] inline PixelBox patch_box(const Photodiode& patch, int width, int height) {
  PixelBox box{.width = patch.size, .height = patch.size};
  if (patch.centre) {
    box.left = static_cast<int>(std::lround((*patch.centre)[0] * width)) - patch.size / 2;
    box.top = static_cast<int>(std::lround((*patch.centre)[1] * height)) - patch.size / 2;
    return box;
  }
  const bool right = patch.corner == Corner::UpperRight || patch.corner == Corner::LowerRight;
  const bool lower = patch.corner == Corner::LowerLeft || patch.corner == Corner::LowerRight;
  box.left = right ? width - patch.size : 0;
  box.top = lower ? height - patch.size : 0;
  return box;
}

/// A rectangular pulse on a channel of the sound output, at auditory zero.
struct Click {
  int channel = 0;  ///< from 1
  Duration length = std::chrono::milliseconds{1};
  double amplitude = 0.5;  ///< of full scale
};

/// Bytes on a serial port: 8 data bits, no parity, 1 stop bit, no flow control.
struct SerialTriggers {
  std::string port;  ///< "/dev/ttyUSB0"
  int baud = 115'200;
  /// By TriggerEvent, 1 to 255; absent: it is not told.
  std::array<std::optional<int>, kTriggerEvents.size()> codes{};
  std::optional<Duration> reset_after;  ///< then the byte 0 follows; absent: it does not
};

/// Lines of JSON on a local socket that the session listens on.
struct SocketTriggers {
  std::string path;
};

/// Which equipment is told of a session's events, and how.
struct Triggers {
  std::optional<Photodiode> photodiode;
  std::optional<Click> click;
  std::optional<SerialTriggers> serial;
  std::optional<SocketTriggers> socket;
};

}  // namespace bimodal::protocols
