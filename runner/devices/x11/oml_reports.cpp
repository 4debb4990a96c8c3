#include "runner/devices/x11/oml_reports.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace bimodal::runner {
namespace {

constexpr Duration kAskEvery = std::chrono::microseconds{500};

}  // namespace

OmlReports::OmlReports(std::unique_ptr<SyncControl> control, const Clock& clock, Sleep sleep)
    : control_{std::move(control)}, clock_{clock}, sleep_{std::move(sleep)} {
  if (const auto now = control_->counters()) swaps_ = now->sbc;
}

void OmlReports::request() {
  ++swaps_;
}

std::optional<PresentationReport> OmlReports::await(Duration patience, const Meanwhile& meanwhile) {
  if (!is_done(clock_.now() + patience, meanwhile)) return std::nullopt;
  const auto done = control_->await_swap(swaps_);
  if (!done) return std::nullopt;
  const auto report = report_of_swap(*done, swaps_);
  swaps_ = std::max(swaps_, done->sbc);
  return report;
}

bool OmlReports::is_done(Instant until, const Meanwhile& meanwhile) {
  while (true) {
    const auto counters = control_->counters();
    if (!counters) return false;
    if (counters->sbc >= swaps_) return true;
    meanwhile();
    const auto now = clock_.now();
    if (now >= until) return false;
    sleep_(std::min(until, now + kAskEvery));
  }
}

std::string OmlReports::description() const {
  return "reported by the driver (GLX_OML_sync_control), stamped at the refresh";
}

}  // namespace bimodal::runner
