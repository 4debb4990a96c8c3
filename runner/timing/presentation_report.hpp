#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "runner/timing/time_source_verdict.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// What the window system or the driver says about one picture.
struct PresentationReport {
  Instant shown;  ///< session clock
  /// The refresh at which that was, counted by the screen since some origin; absent: it counts
  /// none.
  std::optional<std::uint64_t> refresh;
};

/// Refreshes that passed from one report to a later one; absent where either counts none, or the
/// counter went back. Of two pictures handed over for consecutive refreshes it is 1; 2 means that
/// one refresh was missed.
[[nodiscard]] std::optional<std::uint64_t> refreshes_between(const PresentationReport& before,
                                                             const PresentationReport& after);

/// A report, and when it was received on the session clock.
struct ReceivedReport {
  PresentationReport report;
  Instant received;
};

/// Reports that judge_reports() needs at least.
inline constexpr std::size_t kFewestReports = 16;

/// Whether the reports about successive pictures can be believed: each within a second of its
/// receipt (else they are on another clock), every picture shown later than the one before, and all
/// proceeding with the session clock to 2 % (and 5 ms).
[[nodiscard]] TimeSourceVerdict judge_reports(std::span<const ReceivedReport> reports);

/// Whether their counter counts refreshes: each picture at a later one than that before, and the
/// mean time from one count to the next within 20 % of `period`, that of the measured pictures,
/// divided by a whole number (a compositor may show a new picture at every second refresh only).
[[nodiscard]] bool counts_refreshes(std::span<const ReceivedReport> reports, Duration period);

/// The counters of GLX_OML_sync_control (revision 6.0, 2003).
struct SyncCounters {
  std::int64_t ust = 0;  ///< "unadjusted system time": microseconds, in Mesa of CLOCK_MONOTONIC
  std::int64_t msc = 0;  ///< "media stream counter": refreshes of the screen
  std::int64_t sbc = 0;  ///< "swap buffer counter": swaps of the window that are done
};

/// What the counters at the completion of swap number `swap` say about its picture; absent when
/// they are those of another swap, or when the driver filled in no time. An `msc` of 0 counts
/// nothing.
[[nodiscard]] std::optional<PresentationReport> report_of_swap(const SyncCounters& done,
                                                               std::int64_t swap);

}  // namespace bimodal::runner
