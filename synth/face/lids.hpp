#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/field_table.hpp"

namespace bimodal::synth {

/// Closes the eyelids: their vertices slide over the eyeball.
class Lids {
 public:
  Lids(const FieldTable& table, std::span<const glm::dvec3> rest);

  /// 0 open, 1 shut, down to -0.25 wide.
  void close(double left, double right, std::span<glm::dvec3> skin) const;

 private:
  struct LidVertex {
    std::size_t vertex;
    int ring;       ///< 1 and 2 orbit, 3 plate, 4 front edge, 5 back edge, 6 behind the eyeball's
                    ///< surface
    double travel;  ///< mm up for full closure; negative on the upper lid
  };

  std::vector<LidVertex> left_;
  std::vector<LidVertex> right_;

  static void close_eye(double closure,
                        std::span<const LidVertex> lids,
                        std::span<glm::dvec3> skin);
};

}  // namespace bimodal::synth
