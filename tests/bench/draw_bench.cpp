#include <benchmark/benchmark.h>

#include "stimuli/base/asset.hpp"
#include "synth/render/head_renderer.hpp"

namespace bimodal::synth {
namespace {

/// A frame each time, posed, drawn and read back, while the mouth opens.
void draw_opening_mouth(benchmark::State& state, HeadRenderer& renderer) {
  Pose pose = neutral_pose();
  Image image;
  double jaw_deg = 0.0;
  for (auto _ : state) {
    jaw_deg = jaw_deg < 12.0 ? jaw_deg + 0.5 : 0.0;
    value(pose, Control::Jaw) = jaw_deg;
    renderer.draw(pose, image);
    benchmark::DoNotOptimize(image.pixels.data());
  }
  state.counters["pictures/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

/// One frame of an open mouth, posed, drawn and read back; state.range(0) pixels high.
void draw_head(benchmark::State& state) {
  const Head head{asset("synth/assets/head")};
  View view;
  view.height = static_cast<std::size_t>(state.range(0));
  view.width = view.height * 8 / 9;
  HeadRenderer renderer{head, view};
  state.SetLabel(renderer.description());
  draw_opening_mouth(state, renderer);
}

BENCHMARK(draw_head)
    ->Arg(360)
    ->Arg(720)
    ->Arg(1080)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// The same in full quality, at the size of a small screen; state.range(0) samples a pixel. The
/// time of the processor is that of all threads: software OpenGL draws with one for each core.
void draw_head_in_full(benchmark::State& state) {
  const Head head{asset("synth/assets/head")};
  Appearance appearance;
  appearance.quality = Quality::Full;
  appearance.samples = static_cast<int>(state.range(0));
  HeadRenderer renderer{head, {.width = 1280, .height = 1024}, appearance};
  draw_opening_mouth(state, renderer);
}

BENCHMARK(draw_head_in_full)
    ->Arg(1)
    ->Arg(4)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// What every renderer costs before its first frame.
void make_renderer(benchmark::State& state) {
  const Head head{asset("synth/assets/head")};
  for (auto _ : state) {
    HeadRenderer renderer{head, View{}};
    benchmark::DoNotOptimize(&renderer);
  }
}

BENCHMARK(make_renderer)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace bimodal::synth
