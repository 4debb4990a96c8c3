#include "runner/booth/refresh_watch.hpp"

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

}  // namespace bimodal::runner
