#pragma once

#include <cstdint>
#include <vector>

#include "synth/render/image.hpp"

namespace bimodal::synth {

/// Takes the staircase out of edges: where brightness jumps, the edge is followed both ways to its
/// ends, and each pixel is mixed with its neighbour across it by as much as the true line would
/// cover (after Lottes, FXAA, NVIDIA white paper 2009). Pixels without an edge keep their value.
///
/// Why not more samples a pixel: for the whole head at 640 x 720 with software OpenGL, 4 samples a
/// pixel took 127 ms of processor time a frame where one sample took 31 ms; this filter takes about
/// 3 ms.
class EdgeSmoothing {
 public:
  /// `raw` and `smooth` are different pictures; `smooth` keeps its memory.
  void apply(const Image& raw, Image& smooth);

 private:
  std::vector<std::uint8_t> luma_;
};

}  // namespace bimodal::synth
