#include <benchmark/benchmark.h>

#include "stimuli/base/asset.hpp"
#include "synth/face/head.hpp"

namespace bimodal::synth {
namespace {

/// Everything that moves, for one frame of a talking mouth: deformed, subdivided, with normals.
void pose_head(benchmark::State& state) {
  const Head head{asset("synth/assets/head")};
  Pose pose = neutral_pose();
  PosedHead posed;
  double jaw_deg = 0.0;
  for (auto _ : state) {
    jaw_deg = jaw_deg < 12.0 ? jaw_deg + 0.5 : 0.0;
    value(pose, Control::Jaw) = jaw_deg;
    value(pose, Control::LipWidth) = -jaw_deg;
    value(pose, Control::TongueTip) = jaw_deg;
    head.pose(pose, posed);
    benchmark::DoNotOptimize(posed.surfaces.data());
  }
}

BENCHMARK(pose_head)->Unit(benchmark::kMicrosecond);

/// What every program pays before its first face: files read, stencils and distances worked out.
void read_head(benchmark::State& state) {
  for (auto _ : state) {
    const Head head{asset("synth/assets/head")};
    benchmark::DoNotOptimize(&head);
  }
}

BENCHMARK(read_head)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bimodal::synth
