#pragma once

#include <filesystem>
#include <string>

#include "synth/inspection/worked_continuum.hpp"

namespace bimodal::runner {

/// controls.svg: the opening of the lips and every control that differs, in the middle, over the
/// tokens. movements.svg: every control that is
/// asked differently over time. `format`: "svg", "pdf" or "png".
void write_token_plots(const synth::Continuum& continuum,
                       const std::string& title,
                       const std::string& format,
                       const std::filesystem::path& folder);

}  // namespace bimodal::runner
