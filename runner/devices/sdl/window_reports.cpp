#include "runner/devices/sdl/window_reports.hpp"

#include <utility>

#include <SDL.h>
#include <SDL_syswm.h>

#include "runner/devices/monotonic_clock.hpp"
#include "runner/devices/wayland/surface_feedback.hpp"
#include "runner/devices/x11/glx_sync_control.hpp"
#include "runner/devices/x11/oml_reports.hpp"

namespace bimodal::runner {
namespace {

ReportCandidate of_surface(const SDL_SysWMinfo& native, SurfaceFeedback::Kind kind) {
  const auto& wayland = native.info.wl;
  auto feedback = std::make_unique<SurfaceFeedback>(wayland.display, wayland.surface, kind);
  ReportCandidate candidate{
      .name = std::string{feedback->name()}, .reports = nullptr, .refusal = feedback->refusal()};
  if (candidate.refusal.empty()) candidate.reports = std::move(feedback);
  return candidate;
}

ReportCandidate of_driver(const Clock& clock) {
  auto found = find_sync_control();
  ReportCandidate candidate{
      .name = "GLX_OML_sync_control", .reports = nullptr, .refusal = std::move(found.refusal)};
  if (found.control) {
    candidate.reports = std::make_unique<OmlReports>(std::move(found.control), clock, sleep_until);
  }
  return candidate;
}

}  // namespace

std::vector<ReportCandidate> report_candidates(const SdlWindow& window, const Clock& clock) {
  std::vector<ReportCandidate> candidates;
  SDL_SysWMinfo native;
  SDL_VERSION(&native.version);
  if (SDL_GetWindowWMInfo(window.native(), &native) != SDL_TRUE) return candidates;
  if (native.subsystem == SDL_SYSWM_WAYLAND) {
    candidates.push_back(of_surface(native, SurfaceFeedback::Kind::Presented));
    candidates.push_back(of_surface(native, SurfaceFeedback::Kind::FrameDrawn));
  } else if (native.subsystem == SDL_SYSWM_X11) {
    candidates.push_back(of_driver(clock));
  }
  return candidates;
}

}  // namespace bimodal::runner
