#include "runner/devices/sdl/sdl_display.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <SDL.h>
#include <SDL_syswm.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

namespace bimodal::runner {
namespace {

constexpr int kUncountedFlips = 20;
constexpr int kMeasuredFlips = 100;
constexpr int kToleratedSilences = 5;  ///< a window just opened may be shown a little later
constexpr Duration kPumpEvery = std::chrono::milliseconds{50};
constexpr Duration kPatience = std::chrono::milliseconds{100};  ///< for one report

double milliseconds(Duration duration) {
  return std::chrono::duration<double, std::milli>{duration}.count();
}

std::unique_ptr<SurfaceFeedback> feedback_of(const SdlWindow& window) {
  SDL_SysWMinfo native;
  SDL_VERSION(&native.version);
  if (SDL_GetWindowWMInfo(window.native(), &native) != SDL_TRUE) return nullptr;
  if (native.subsystem != SDL_SYSWM_WAYLAND) return nullptr;
  const auto& wayland = native.info.wl;
  return std::make_unique<SurfaceFeedback>(wayland.display, wayland.surface);
}

}  // namespace

SdlDisplay::SdlDisplay(SdlWindow& window, const Screen& opening)
    : window_{window}, painter_{window.background()}, feedback_{feedback_of(window)} {
  measure_refresh(opening);
}

void SdlDisplay::measure_refresh(const Screen& opening) {
  using Kind = SurfaceFeedback::Kind;
  if (feedback_ && feedback_->offers(Kind::Presented) &&
      measure_answers(Kind::Presented, opening)) {
    source_ = TimeSource::DriverReported;
  } else if (feedback_ ? measure_answers(Kind::FrameDrawn, opening) : measure_swaps(opening)) {
    source_ = TimeSource::SwapReturned;
  } else {
    nominal_ = {.period = period_of(window_.nominal_rate()), .phase = clock_.now()};
  }
}

/// False when the compositor leaves 5 flips without an answer.
bool SdlDisplay::measure_answers(SurfaceFeedback::Kind kind, const Screen& opening) {
  answer_ = kind;
  meter_ = RefreshMeter{};
  int unanswered = 0;
  for (int flip = 0; flip < kUncountedFlips + kMeasuredFlips + 1; ++flip) {
    SdlWindow::pump();
    painter_.draw(opening, window_.size());
    feedback_->request(kind);
    window_.swap();
    const auto shown = feedback_->await(kPatience);
    if (!shown && ++unanswered == kToleratedSilences) return false;
    if (shown && flip >= kUncountedFlips) meter_.add(*shown);
  }
  return true;
}

/// False when the swap does not wait for the screen.
bool SdlDisplay::measure_swaps(const Screen& opening) {
  std::array<Duration, kUncountedFlips> intervals{};
  const auto nominal = period_of(window_.nominal_rate());
  auto last = clock_.now();
  for (int flip = 0; flip < kUncountedFlips + kMeasuredFlips + 1; ++flip) {
    if (flip == kUncountedFlips && !swap_waits(intervals, nominal)) return false;
    SdlWindow::pump();
    painter_.draw(opening, window_.size());
    window_.swap();
    const auto returned = clock_.now();
    if (flip < kUncountedFlips) {
      intervals.at(static_cast<std::size_t>(flip)) = returned - last;
    } else {
      meter_.add(returned);
    }
    last = returned;
  }
  return true;
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
  wait_until(plan.submit);
  painter_.draw(screen, window_.size());
  auto presentation = source_ == TimeSource::Predicted ? present_clocked(plan)
                      : feedback_                      ? present_answered(plan)
                                                       : present_swapped(plan);
  presentation.lateness = presentation.onset - deadline;
  return presentation;
}

Presentation SdlDisplay::present_answered(const RefreshPlan& plan) {
  feedback_->request(answer_);
  window_.swap();
  if (const auto shown = feedback_->await(kPatience)) {
    meter_.add(*shown);
    return {.onset = *shown, .source = source_};
  }
  return {.onset = std::max(plan.target, clock_.now()), .source = TimeSource::Predicted};
}

Presentation SdlDisplay::present_swapped(const RefreshPlan& plan) {
  window_.swap();
  const auto returned = clock_.now();
  const auto [onset, seen] = onset_of_swap(meter_.estimate(), plan, returned);
  if (!seen) {
    sleep_until(onset);
    return {.onset = onset, .source = TimeSource::Predicted};
  }
  meter_.add(onset);
  return {.onset = onset, .source = TimeSource::SwapReturned};
}

Presentation SdlDisplay::present_clocked(const RefreshPlan& plan) {
  glFinish();
  sleep_until(plan.target);
  window_.swap();
  return {.onset = clock_.now(), .source = TimeSource::Predicted};
}

void SdlDisplay::wait_until(Instant instant) {
  while (instant - clock_.now() > kPumpEvery) {
    SdlWindow::pump();
    sleep_until(std::min(instant, clock_.now() + kPumpEvery));
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
        "{:g} Hz, and onsets are predicted",
        device,
        window_.nominal_rate().count());
  }
  return fmt::format(
      "{}, display mode {:g} Hz, period {:.4f} ms, SD {:.4f} ms over {} periods; onsets {}",
      device,
      window_.nominal_rate().count(),
      milliseconds(grid.period),
      milliseconds(grid.deviation),
      grid.count,
      describe_source());
}

std::string SdlDisplay::describe_source() const {
  if (!feedback_) return "from the return of the swap";
  if (source_ == TimeSource::SwapReturned) {
    return "from the compositor's frame callbacks, up to one refresh before a picture is visible";
  }
  const auto stated = feedback_->stated_period();
  auto text = fmt::format("reported by the compositor, stamped by {}",
                          feedback_->hardware_stamped() ? "the display hardware" : "its own clock");
  if (stated > Duration::zero() && 2 * refresh().period > 3 * stated) {
    text += fmt::format("; it shows a new picture only every {:.1f} refreshes of {:.4f} ms",
                        milliseconds(refresh().period) / milliseconds(stated),
                        milliseconds(stated));
  }
  return text;
}

}  // namespace bimodal::runner
