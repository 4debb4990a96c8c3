#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "synth/fitting/fit.hpp"

namespace bimodal::synth {

/// What a fit tells of a segment of the face: the mean of the parts that stand for it, by how often
/// they occur (of alpha and theta the geometric mean). So AA is also the start of AY and AW, and EY
/// lies between its halves. Absent if none of them occurs in the clips.
[[nodiscard]] std::optional<PartDynamics> dynamics_of(const Fit& fit, Phone segment);

struct FittedMeasure {
  std::string name;
  Fit fit;
};

/// The segments of all fits as JSON: {"definitions": {"B": {"inner_h": {"target": -4.03, "alpha":
/// 2.49, "theta_before_per_ms": 0.022, "theta_after_per_ms": 0.022, "exponent": 1, "offset_ms":
/// -13.4}}, ...}, "about": [...]}. Segments are written in ARPAbet and as "rest", in the order of
/// all_phones(); those that do not occur in the clips are left out.
[[nodiscard]] std::string definitions_json(std::span<const FittedMeasure> measures,
                                           std::span<const std::string> about);

}  // namespace bimodal::synth
