#pragma once

#include <cstdint>
#include <optional>

#include "synth/fitting/measured_clip.hpp"

namespace bimodal::synth {

/// Which parts share a theta.
enum class ThetaSharing : std::uint8_t {
  One,           ///< all, before and after the peak
  Sides,         ///< all before the peak; all after it
  Class,         ///< those of a class, before and after
  ClassAndSide,  ///< those of a class before the peak; after it
};

/// How far parameters may stray from where they are shrunk to: the standard deviations that they
/// are taken to have. Times the shrinkage, these are the ridge of the fit. Chosen once for both
/// measures of six clips: where one of them is halved or doubled, the left-out r of inner height
/// changes by less than .012, that of outer width by less than .035.
struct Spread {
  double class_target = 0.8;      ///< around the target common to all; in SDs of the measure
  double part_target = 0.5;       ///< around its class's; in SDs of the measure
  double log_alpha = 0.4;         ///< around that of the reference class, 0
  double common_offset_ms = 100;  ///< around 0
  double class_offset_ms = 8;     ///< around the common one
  double log_theta = 0.5;         ///< the common one around FitOptions::theta_start_per_ms
  double class_log_theta = 0.25;  ///< around the common one
  double talker = 0.5;            ///< log gain around 0; or offset around 0 in SDs of the measure
};

struct FitOptions {
  MeasureKind kind = MeasureKind::Position;
  ThetaSharing theta = ThetaSharing::One;
  double theta_start_per_ms = 0.018;   ///< between the best for opening (.022) and width (.010)
  std::optional<double> theta_per_ms;  ///< theta of all parts; not fitted then
  /// Whether each clip has a talker of its own: a gain (Opening) or an offset (Position).
  bool own_talkers = true;
  /// What the measure is taken to stray from the model, in SDs of the measure: 0 is least squares
  /// alone, more pulls parameters that few tokens speak for to their class's. >= 0.
  double shrinkage = 0.5;
  Spread spread;
};

}  // namespace bimodal::synth
