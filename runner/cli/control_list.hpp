#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "synth/speech/control.hpp"

namespace bimodal::runner {

/// A pose that the face can take, and what of the wanted one it cannot.
struct AskedPose {
  synth::Pose pose;                  ///< within every control's range
  std::vector<std::string> remarks;  ///< what was out of range, one line each
};

/// `wanted` with every control in its range.
[[nodiscard]] AskedPose possible(const synth::Pose& wanted);

/// The control of a name in files ("lip_width") or in Cohen & Massaro (1993) ("mouth width",
/// "mouth-width"); "width" alone is that of the mouth; case does not count. Throws Error naming
/// what is near.
[[nodiscard]] synth::Control control_called(std::string_view name);

/// Reads "jaw=8", "lip_width=-10", ...; the rest stays neutral; values may be out of range. Throws
/// Error at the first setting that is none, and if a control is set twice.
[[nodiscard]] synth::Pose read_controls(const std::vector<std::string>& settings);

}  // namespace bimodal::runner
