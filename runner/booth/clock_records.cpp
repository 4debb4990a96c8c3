#include "runner/booth/clock_records.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace bimodal::runner {

namespace {

ClockMapRecord record_of(std::string clock, std::string_view source, const DeviceClock& of) {
  return {.clock = std::move(clock),
          .source = std::string{source},
          .at = of.fit.instant.time_since_epoch(),
          .device_at = of.fit.sample,
          .nanoseconds_per_unit = of.fit.nanoseconds_per_sample,
          .residual = of.fit.residual,
          .readings = static_cast<std::int64_t>(of.fit.count),
          .rejected = static_cast<std::int64_t>(of.fit.rejected),
          .jumps = of.jumps};
}

}  // namespace

void note_clocks(const Booth& booth, TrialRecord& record) {
  if (const auto display = booth.display.clock()) {
    record.clock_maps.push_back(record_of("display", name(booth.display.time_source()), *display));
  }
  if (const auto sound = booth.audio.clock()) {
    auto map = record_of("sound", booth.audio.time_source(), *sound);
    map.drift_ppm = sound->fit.drift_ppm;
    record.clock_maps.push_back(std::move(map));
  }
}

}  // namespace bimodal::runner
