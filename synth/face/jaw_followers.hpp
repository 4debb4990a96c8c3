#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/jaw.hpp"

namespace bimodal::synth {

/// The vertices of the skin cage that the jaw carries, each by its own share of the jaw's movement.
class JawFollowers {
 public:
  /// One weight per vertex of the cage, 0 to 1.
  explicit JawFollowers(std::span<const double> weights);

  void move(const JawMotion& jaw, std::span<glm::dvec3> skin) const;

 private:
  struct Follower {
    std::size_t vertex;
    double weight;
  };

  std::vector<Follower> followers_;  ///< of equal weight side by side: they move as one
};

}  // namespace bimodal::synth
