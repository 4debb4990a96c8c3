// How long a film of the face takes, 640 x 720 at 60 Hz, and what of that is neither drawing nor
// coding: processor time of all threads of the film, less that of the same pictures drawn and
// thrown away, and coded when drawn already, all in one run.

#include <ctime>
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

/// Processor time of all threads so far, ms.
double spent() {
  return static_cast<double>(std::clock()) * 1e3 / CLOCKS_PER_SEC;
}

std::vector<synth::Pose> poses_of_a_word() {
  const synth::SegmentTable table{asset("synth/assets/segments/english.json")};
  const auto segments = synth::typed_segments("T EH M P AX R EH R IY F UW D S T UW");
  return synth::Articulation{segments, table}.sample(Hertz{60});
}

class Studio {
 public:
  explicit Studio(const char* ending)
      : file_{std::filesystem::temp_directory_path() /
              ("bimodal_bench_" + std::to_string(::getpid()) + ending)} {}

  ~Studio() { std::filesystem::remove(file_); }

  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;
  Studio(Studio&&) = delete;
  Studio& operator=(Studio&&) = delete;

  void draw_and_encode() {
    VideoWriter video{file_, options()};
    for (const auto& pose : poses_) {
      renderer_.draw(pose, picture_);
      video.add(picture_);
    }
    video.finish();
  }

  void draw() {
    for (const auto& pose : poses_) renderer_.draw(pose, picture_);
  }

  /// `pictures`: drawn before.
  void encode(const std::vector<Image>& pictures) const {
    VideoWriter video{file_, options()};
    for (const auto& picture : pictures) video.add(picture);
    video.finish();
  }

  std::vector<Image> pictures() {
    std::vector<Image> result;
    for (const auto& pose : poses_) {
      renderer_.draw(pose, picture_);
      result.push_back(picture_);
    }
    return result;
  }

 private:
  [[nodiscard]] VideoOptions options() const {
    return {.width = view_.width,
            .height = view_.height,
            .rate = rate_in(*video_form_of(file_), FrameRate{60})};
  }

  std::filesystem::path file_;
  synth::View view_;
  synth::Head head_{asset("synth/assets/head")};
  synth::HeadRenderer renderer_{head_, view_};
  std::vector<synth::Pose> poses_ = poses_of_a_word();
  Image picture_;
};

void write_a_film(benchmark::State& state, const char* ending) {
  Studio studio{ending};
  const auto pictures = studio.pictures();
  double drawing = 0;
  double encoding = 0;
  double whole = 0;
  for (auto _ : state) {
    const double begin = spent();
    studio.draw_and_encode();
    whole += spent() - begin;
    state.PauseTiming();
    const double before_drawing = spent();
    studio.draw();
    const double before_encoding = spent();
    studio.encode(pictures);
    drawing += before_encoding - before_drawing;
    encoding += spent() - before_encoding;
    state.ResumeTiming();
  }
  const auto films = static_cast<double>(state.iterations());
  state.counters["pictures"] = static_cast<double>(pictures.size());
  state.counters["cpu ms"] = whole / films;
  state.counters["drawing cpu ms"] = drawing / films;
  state.counters["coding cpu ms"] = encoding / films;
  state.counters["own %"] = 100.0 * (whole - drawing - encoding) / whole;
}

BENCHMARK_CAPTURE(write_a_film, mp4, ".mp4")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(write_a_film, webm, ".webm")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(write_a_film, gif, ".gif")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace bimodal
