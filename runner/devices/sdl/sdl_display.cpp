#include "runner/devices/sdl/sdl_display.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "runner/devices/sdl/window_reports.hpp"
#include "stimuli/base/milliseconds.hpp"

namespace bimodal::runner {
namespace {

constexpr int kUncountedFlips = 20;
constexpr int kMeasuredFlips = 100;
constexpr int kToleratedSilences = 5;  ///< a window just opened may be shown a little later
constexpr Duration kPumpEvery = std::chrono::milliseconds{1};
constexpr Duration kPatience = std::chrono::milliseconds{100};  ///< for one report

}  // namespace

SdlDisplay::SdlDisplay(SdlWindow& window, const Screen& opening)
    : window_{window}, painter_{window.background()}, pump_{[this] { window_.pump(); }} {
  measure_refresh(opening);
  start_up_.nominal = period_of(window_.nominal_rate());
  start_up_.is_seen = source_ != TimeSource::Predicted;
  start_up_.is_composited = SdlWindow::driver() == "wayland";
  start_up_.by_hardware = source_ == TimeSource::DriverReported && reports_->by_hardware();
  start_up_.source = start_up_.is_seen ? describe_source() : "predicted";
}

void SdlDisplay::measure_refresh(const Screen& opening) {
  for (auto& candidate : report_candidates(window_, clock_)) {
    if (candidate.reports) {
      reports_ = std::move(candidate.reports);
      candidate.refusal = measure_reports(opening);
      if (candidate.refusal.empty()) {
        source_ = reports_->source();
        return;
      }
      reports_.reset();
    }
    not_used_ += fmt::format("; not by {}: {}", candidate.name, candidate.refusal);
  }
  if (SdlWindow::driver() != "wayland" && measure_swaps(opening)) {
    source_ = TimeSource::SwapReturned;
  } else {
    nominal_ = {.period = period_of(window_.nominal_rate()), .phase = clock_.now()};
  }
}

/// Why the reports cannot be used; empty: they can.
std::string SdlDisplay::measure_reports(const Screen& opening) {
  meter_ = RefreshMeter{};
  std::array<ReceivedReport, kMeasuredFlips + 1> received{};
  std::size_t count = 0;
  int unanswered = 0;
  for (int flip = 0; flip < kUncountedFlips + kMeasuredFlips + 1; ++flip) {
    window_.pump();
    painter_.draw(opening, window_.size());
    reports_->request();
    window_.swap();
    const auto report = reports_->await(kPatience, pump_);
    if (!report && ++unanswered == kToleratedSilences) {
      return fmt::format("no answer to {} of {} pictures", unanswered, flip + 1);
    }
    if (!report || flip < kUncountedFlips) continue;
    received.at(count++) = {.report = *report, .received = clock_.now()};
  }
  const auto reports = std::span{received}.first(count);
  const auto verdict = judge_reports(reports);
  if (!verdict.plausible) return std::string{verdict.reason};
  std::array<Instant, kMeasuredFlips + 1> flips{};
  std::ranges::transform(
      reports, flips.begin(), [](const ReceivedReport& each) { return each.report.shown; });
  sum_up(std::span{flips}.first(count));
  last_shown_ = reports.back().report.shown;
  counted_ = counts_refreshes(reports, meter_.estimate().period);
  return {};
}

/// False when the swap does not wait for the screen.
bool SdlDisplay::measure_swaps(const Screen& opening) {
  std::array<Duration, kUncountedFlips> intervals{};
  const auto nominal = period_of(window_.nominal_rate());
  std::array<Instant, kMeasuredFlips + 1> flips{};
  auto last = clock_.now();
  for (int flip = 0; flip < kUncountedFlips + kMeasuredFlips + 1; ++flip) {
    if (flip == kUncountedFlips && !swap_waits(intervals, nominal)) return false;
    window_.pump();
    painter_.draw(opening, window_.size());
    window_.swap();
    const auto returned = clock_.now();
    if (flip < kUncountedFlips) {
      intervals.at(static_cast<std::size_t>(flip)) = returned - last;
    } else {
      flips.at(static_cast<std::size_t>(flip - kUncountedFlips)) = returned;
    }
    last = returned;
  }
  sum_up(flips);
  return true;
}

/// The counted flips at start-up: the grid that the session begins with, and what to judge it by.
void SdlDisplay::sum_up(std::span<const Instant> flips) {
  start_up_.intervals.clear();
  for (std::size_t i = 0; i < flips.size(); ++i) {
    meter_.add(flips[i]);
    if (i > 0) start_up_.intervals.push_back(flips[i] - flips[i - 1]);
  }
}

RefreshEstimate SdlDisplay::refresh() const {
  return source_ == TimeSource::Predicted ? nominal_ : meter_.estimate();
}

std::optional<DeviceClock> SdlDisplay::clock() const {
  if (source_ == TimeSource::Predicted) return std::nullopt;
  return DeviceClock{meter_.fit(), static_cast<int>(meter_.counts().restarts)};
}

Presentation SdlDisplay::present(const Screen& screen, Instant deadline) {
  const auto plan = plan_refresh(refresh(), clock_.now(), deadline);
  wait(plan.submit);
  painter_.draw(screen, window_.size());
  auto presentation = source_ == TimeSource::Predicted ? present_clocked(plan)
                      : reports_                       ? present_reported(plan)
                                                       : present_swapped(plan);
  presentation.lateness = presentation.onset - deadline;
  return presentation;
}

Presentation SdlDisplay::present_reported(const RefreshPlan& plan) {
  reports_->request();
  window_.swap();
  const auto report = reports_->await(kPatience, pump_);
  if (report && report->shown > last_shown_) {
    last_shown_ = report->shown;
    meter_.add(report->shown);
    return {.onset = report->shown,
            .source = source_,
            .refresh = counted_ ? report->refresh : std::nullopt};
  }
  return {.onset = std::max(plan.target, clock_.now()), .source = TimeSource::Predicted};
}

Presentation SdlDisplay::present_swapped(const RefreshPlan& plan) {
  window_.swap();
  const auto returned = clock_.now();
  const auto [onset, seen] = onset_of_swap(meter_.estimate(), plan, returned);
  if (!seen) {
    wait(onset);
    return {.onset = onset, .source = TimeSource::Predicted};
  }
  meter_.add(onset);
  return {.onset = onset, .source = TimeSource::SwapReturned};
}

Presentation SdlDisplay::present_clocked(const RefreshPlan& plan) {
  glFinish();
  wait(plan.target);
  window_.swap();
  return {.onset = clock_.now(), .source = TimeSource::Predicted};
}

void SdlDisplay::wait(Instant instant) {
  while (instant - clock_.now() > kPumpEvery) {
    sleep_until(std::min(instant, clock_.now() + kPumpEvery));
    window_.pump();
  }
  sleep_until(instant);
}

std::string SdlDisplay::description() const {
  const auto size = window_.size();
  const auto grid = refresh();
  const auto device = fmt::format("{}, {}, {} x {} pixels",
                                  SdlWindow::driver(),
                                  SdlWindow::renderer(),
                                  size.width,
                                  size.height);
  if (source_ == TimeSource::Predicted) {
    return fmt::format(
        "{}; this display does not report refreshes: they are kept by the clock at its nominal "
        "{:g} Hz, and onsets are predicted{}",
        device,
        window_.nominal_rate().count(),
        not_used_);
  }
  return fmt::format(
      "{}, display mode {:g} Hz, period {:.4f} ms, SD {:.4f} ms over {} periods; onsets {}{}",
      device,
      window_.nominal_rate().count(),
      milliseconds(grid.period),
      milliseconds(grid.deviation),
      grid.count,
      describe_source(),
      not_used_);
}

std::string SdlDisplay::describe_source() const {
  if (!reports_) return "from the return of the swap";
  auto text = reports_->description();
  if (counted_) text += ", with a count of refreshes";
  const auto stated = reports_->stated_period();
  if (stated > Duration::zero() && 2 * refresh().period > 3 * stated) {
    text += fmt::format("; it shows a new picture only every {:.1f} refreshes of {:.4f} ms",
                        milliseconds(refresh().period) / milliseconds(stated),
                        milliseconds(stated));
  }
  return text;
}

}  // namespace bimodal::runner
