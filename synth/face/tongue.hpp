#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "synth/face/jaw.hpp"
#include "synth/speech/control.hpp"

namespace bimodal::synth {

inline constexpr std::size_t kTongueStations = 15;  ///< from root to tip
inline constexpr std::size_t kTongueRound = 12;     ///< points round each station
inline constexpr std::size_t kTongueVertices = kTongueStations * kTongueRound + 1;

using TongueCage = std::array<glm::dvec3, kTongueVertices>;

/// The tongue's control cage: a tube of given half width and half thickness round a Bezier midline,
/// which the tongue controls lengthen, turn, curl and arch; carried by the jaw. What it may meet
/// stops it only when it is drawn (TongueContact). Station by station from the root; the tip is the
/// last vertex.
[[nodiscard]] TongueCage tongue_cage(const Pose& pose, const JawMotion& jaw);

}  // namespace bimodal::synth
