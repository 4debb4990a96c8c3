#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runner/devices/presentation_reports.hpp"
#include "runner/devices/sdl/sdl_window.hpp"

namespace bimodal::runner {

/// Somebody who might tell when the window's pictures were shown, or why he cannot.
struct ReportCandidate {
  std::string name;
  std::unique_ptr<PresentationReports> reports;  ///< none: see refusal
  std::string refusal;
};

/// All that this window system could have, best first; none on a console (KMSDRM).
[[nodiscard]] std::vector<ReportCandidate> report_candidates(const SdlWindow& window,
                                                             const Clock& clock);

}  // namespace bimodal::runner
