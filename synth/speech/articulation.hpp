#pragma once

#include <vector>

#include "stimuli/timeline/utterance.hpp"
#include "synth/speech/control.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::synth {

/// The rest before and after speech has its peak this far outside of it (the fit to natural lips
/// that the dynamics come from was made so).
inline constexpr Duration kRestDistance = std::chrono::milliseconds{100};

/// The first segment of a diphthong lasts this part of it (as in the fit to natural lips).
inline constexpr double kDiphthongSplit = 0.55;

/// The segments of the face that an utterance stands for: each phone, diphthongs as their two
/// halves, neighbouring rests as one. An utterance without phones is one rest.
[[nodiscard]] std::vector<TimedPhone> segments_of(const Utterance& utterance);

/// The claims that `segments` make on one control, in their order: peak t_c + t_o, where t_c is the
/// segment's centre (to the nanosecond below). A rest at either end is special: its t_c lies
/// kRestDistance outside the speech, whatever its duration, and its dominance is constant from its
/// peak outwards, so that the length of a pause does not change the movement.
[[nodiscard]] std::vector<Claim> claims_on(Control control,
                                           const std::vector<TimedPhone>& segments,
                                           const SegmentTable& table);

/// The movement of the face for one utterance: every speech control as a function of time, by the
/// dominance model of Cohen & Massaro (1993, equations 1-6). Values may lie beyond a control's
/// range (a closure target beyond contact); the face clamps them.
class Articulation {
 public:
  Articulation(const Utterance& utterance, const SegmentTable& table);

  /// Every control at `time` since the start of the utterance; defined for all times. The controls
  /// that speech does not set are neutral.
  [[nodiscard]] Pose at(Duration time) const;

  /// Poses at the instants 0, 1/rate, 2/rate ... that lie before the utterance's end.
  [[nodiscard]] std::vector<Pose> sample(Hertz rate) const;

 private:
  /// One segment's dominance over the controls of a channel.
  struct Peak {
    double time_ms;
    double log_alpha;
    double theta_before;
    double theta_after;
    double exponent;

    bool operator==(const Peak&) const = default;
  };

  struct ControlTargets {
    Control control;
    std::vector<double> targets;  ///< one per peak
  };

  /// Controls that move with the same dynamics, whose weights are computed once for all of them.
  struct Channel {
    std::vector<Peak> peaks;
    std::vector<ControlTargets> controls;
  };

  /// at(), with work space that several calls share.
  [[nodiscard]] Pose at(Duration time, std::vector<double>& weights) const;

  /// Sets the channel's controls in `pose` to equation 6 at `time_ms`; `weights` is work space.
  static void blend(const Channel& channel,
                    double time_ms,
                    std::vector<double>& weights,
                    Pose& pose);

  std::vector<Channel> channels_;
  Duration end_{};
};

}  // namespace bimodal::synth
