#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// One reading of a device's clock: that sample was (or will be) at the output at that instant.
struct ClockPair {
  std::int64_t sample = 0;
  Instant instant;

  bool operator==(const ClockPair&) const = default;
};

/// A straight line from stream samples to session instants, and how well it fits.
struct ClockFit {
  std::int64_t sample = 0;            ///< a sample among the readings
  Instant instant;                    ///< when it is at the output
  double nanoseconds_per_sample = 0;  ///< on the session clock
  double drift_ppm = 0.0;             ///< device seconds per session second, minus 1, in millionths
  Duration residual{};                ///< standard deviation of the readings used about the line
  std::size_t count = 0;              ///< readings used
  std::size_t rejected = 0;           ///< readings too far from the line (an interrupted callback)

  [[nodiscard]] Instant instant_of(std::int64_t at) const;

  /// The sample nearest to an instant.
  [[nodiscard]] std::int64_t sample_at(Instant at) const;
};

/// How a device's clock lies on the session clock.
struct DeviceClock {
  ClockFit fit;   ///< of a sound stream's samples, or of a display's refreshes
  int jumps = 0;  ///< since the session began: lost buffers, or another rate
  std::optional<std::int64_t> latest_jump = std::nullopt;  ///< the first sample after it
};

/// Fits a line through readings whose errors are mostly small but sometimes large. Start: the
/// median slope of pairs half the readings apart and the median offset (Theil 1950, thinned), or,
/// where the readings span less than `shortest_for_drift`, the nominal rate. Then readings farther
/// off than 4 robust standard deviations (1.4826 times the median absolute deviation), but at least
/// half a sample, are left out, and a least-squares line (of the nominal rate, in the latter case)
/// is fitted to the rest. Absent without readings.
[[nodiscard]] std::optional<ClockFit> fit_clock(std::span<const ClockPair> pairs,
                                                Hertz nominal_rate,
                                                Duration shortest_for_drift);

/// Fits again and again without allocating, up to so many readings at a time.
class ClockFitter {
 public:
  explicit ClockFitter(std::size_t most);

  /// As fit_clock(); at most `most` pairs.
  [[nodiscard]] std::optional<ClockFit> fit(std::span<const ClockPair> pairs,
                                            Hertz nominal_rate,
                                            Duration shortest_for_drift);

 private:
  /// Relative to the reading in the middle, so that nothing is lost in doubles.
  struct Reading {
    double sample = 0.0;
    double nanoseconds = 0.0;
  };

  struct Line {
    double offset = 0.0;
    double slope = 0.0;
  };

  static double residual(const Reading& reading, const Line& line);
  double median_slope(double otherwise);
  double median_residual(const Line& line);
  void leave_out_far_ones(const Line& line, double smallest_limit);
  [[nodiscard]] Line least_squares() const;
  [[nodiscard]] double mean_residual(double slope) const;
  [[nodiscard]] double standard_deviation(const Line& line, std::size_t parameters) const;

  std::vector<Reading> readings_;
  std::vector<double> values_;  ///< of which a median is to be found
};

struct ClockMapOptions {
  std::size_t most = 1024;                         ///< older readings are forgotten
  Duration window = std::chrono::seconds{20};      ///< and so are those longer ago than this
  Duration longest_gap = std::chrono::seconds{1};  ///< without readings; after it we start anew
  Duration shortest_for_drift = std::chrono::milliseconds{500};
  Duration jump = std::chrono::milliseconds{1};  ///< smallest offset that counts as one
  std::size_t confirmations = 8;  ///< successive readings off to the same side that confirm a jump
};

/// Follows a device's sample clock. After a jump (an underflow: samples came late by whole buffers)
/// or a gap without readings everything before it is forgotten, and counted as a jump. Used by one
/// thread. Allocates nothing after construction.
class ClockMap {
 public:
  explicit ClockMap(Hertz nominal_rate, ClockMapOptions options = {});

  /// Readings come in the order of their samples.
  void add(const ClockPair& pair);

  /// Absent before the first reading.
  [[nodiscard]] const std::optional<ClockFit>& fit();

  /// Jumps noticed so far.
  [[nodiscard]] int jumps() const { return jumps_; }

  /// The first sample known to lie after the latest jump; absent before any.
  [[nodiscard]] std::optional<std::int64_t> latest_jump() const { return latest_jump_; }

 private:
  void forget_all_but(std::size_t latest);
  void note_jump(std::int64_t sample);
  void renew_judge();
  void notice_jump(const ClockPair& pair);

  Hertz nominal_rate_;
  ClockMapOptions options_;

  [[nodiscard]] std::span<const ClockPair> pairs() const {
    return std::span{pairs_}.subspan(first_);
  }

  ClockFitter fitter_;
  std::vector<ClockPair> pairs_;  ///< the oldest, up to first_, are forgotten
  std::size_t first_ = 0;
  bool fitted_ = false;  ///< fit_ is that of pairs_
  std::optional<ClockFit> fit_;
  std::optional<ClockFit> judge_;  ///< a recent fit, by which jumps are noticed
  std::size_t since_judge_ = 0;
  std::size_t early_ = 0;  ///< successive readings well before their predicted instant
  std::size_t late_ = 0;
  int jumps_ = 0;
  std::optional<std::int64_t> latest_jump_;
};

}  // namespace bimodal::runner
