#include "runner/booth/refresh_watch.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "stimuli/base/milliseconds.hpp"

namespace bimodal::runner {

void watch_refreshes(const Booth& booth, Oversight& oversight) {
  constexpr int kEnough = 100;
  constexpr int kMost = 300;
  if (booth.display.time_source() == TimeSource::Predicted) return;
  for (int more = 0; more < kMost; ++more) {
    if (booth.display.refresh().count >= kEnough || oversight.stop_asked()) return;
    static_cast<void>(booth.display.present({}, booth.clock.now()));
    static_cast<void>(booth.keyboard.poll());
  }
}

bool is_another_period(Duration period, Duration before) {
  constexpr int kPart = 50;  // 2 %
  return std::chrono::abs(period - before) > before / kPart;
}

std::string ScreenGuard::trouble(const TrialRecord& record, const RefreshEstimate& refresh) {
  if (std::ranges::find(record.events, "screen_silent", &EventRecord::kind) !=
      record.events.end()) {
    return "the screen reports nothing: it may be asleep, or its window hidden";
  }
  if (refresh.count == 0) return {};  // it is not measured
  const auto before = std::exchange(period_, refresh.period).value_or(refresh.period);
  if (!is_another_period(refresh.period, before)) return {};
  return fmt::format("the screen refreshes every {:.2f} ms, not every {:.2f} ms as before",
                     milliseconds(refresh.period),
                     milliseconds(before));
}

}  // namespace bimodal::runner
