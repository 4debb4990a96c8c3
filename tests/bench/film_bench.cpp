// How long a film of the face takes, 640 x 720 at 60 Hz, and how much of that is drawing: what is
// beyond is coding that was not done meanwhile on the other core.

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/video/video_writer.hpp"
#include "synth/render/head_renderer.hpp"
#include "synth/speech/articulation.hpp"
#include "synth/speech/durations.hpp"

namespace bimodal {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>{Clock::now() - begin}.count();
}

std::vector<synth::Pose> poses_of_a_word() {
  const synth::SegmentTable table{asset("synth/assets/segments/english.json")};
  const auto segments = synth::typed_segments("T EH M P AX R EH R IY F UW D S T UW");
  return synth::Articulation{segments, table}.sample(Hertz{60});
}

void write_a_film(benchmark::State& state, const char* ending) {
  const auto poses = poses_of_a_word();
  const synth::Head head{asset("synth/assets/head")};
  const synth::View view;
  synth::HeadRenderer renderer{head, view};
  const auto file = std::filesystem::temp_directory_path() /
                    ("bimodal_bench_" + std::to_string(::getpid()) + ending);
  const auto rate = rate_in(*video_form_of(file), FrameRate{60});
  double drawing = 0;
  Image picture;
  for (auto _ : state) {
    VideoWriter video{file, {.width = view.width, .height = view.height, .rate = rate}};
    for (const auto& pose : poses) {
      const auto begin = Clock::now();
      renderer.draw(pose, picture);
      drawing += seconds_since(begin);
      video.add(picture);
    }
    video.finish();
  }
  std::filesystem::remove(file);
  const auto films = static_cast<double>(state.iterations());
  state.counters["frames"] = static_cast<double>(poses.size());
  state.counters["drawing ms"] = drawing / films * 1e3;
}

BENCHMARK_CAPTURE(write_a_film, mp4, ".mp4")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(write_a_film, webm, ".webm")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(write_a_film, gif, ".gif")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace bimodal
