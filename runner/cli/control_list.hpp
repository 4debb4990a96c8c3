#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "synth/speech/control.hpp"

namespace bimodal::runner {

/// A pose as it was asked for.
struct AskedPose {
  synth::Pose pose;                  ///< within every control's range
  std::vector<std::string> remarks;  ///< what was out of range, one line each
};

/// The control of a name in files ("lip_width") or in Cohen & Massaro (1993) ("mouth width",
/// "mouth-width"); "width" alone is that of the mouth; case does not count. Throws Error naming
/// what is near.
[[nodiscard]] synth::Control control_called(std::string_view name);

/// Reads "jaw=8", "lip_width=-10", ...; the rest stays neutral. Throws Error at the first setting
/// that is none, and if a control is set twice.
[[nodiscard]] AskedPose read_controls(const std::vector<std::string>& settings);

}  // namespace bimodal::runner
