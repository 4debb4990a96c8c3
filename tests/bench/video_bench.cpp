// How long the natural video and the sound of a trial take to be ready: less than a quarter of
// their length is needed. Ten seconds of 720 x 576 at 25 frames a second, shown 720 pixels high.

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "stimuli/audio/time_scale.hpp"
#include "stimuli/video/frame_reader.hpp"
#include "stimuli/video/sound_track.hpp"

namespace bimodal {
namespace {

constexpr double kSeconds = 10.0;

/// Made once by the ffmpeg program; empty if it is absent. Removed when the benchmark ends.
class Recording {
 public:
  Recording(const char* name, const char* options)
      : file_{std::filesystem::temp_directory_path() /
              ("bimodal_bench_" + std::to_string(::getpid()) + name)} {
    const auto command =
        "ffmpeg -nostdin -v error -y -f lavfi -i "
        "testsrc2=s=720x576:r=25:d=10,noise=alls=6:allf=t,setsar=16/15 "
        "-f lavfi -i sine=r=48000:d=10 " +
        std::string{options} + " '" + file_.string() + "'";
    made_ = std::system(command.c_str()) == 0;
  }

  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  Recording(Recording&&) = delete;
  Recording& operator=(Recording&&) = delete;

  ~Recording() {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }

  [[nodiscard]] bool made() const { return made_; }

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
  bool made_ = false;
};

void report(benchmark::State& state) {
  state.counters["seconds of video a second"] = benchmark::Counter(
      kSeconds * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void read_all_frames(benchmark::State& state, const char* name, const char* options) {
  const Recording recording{name, options};
  if (!recording.made()) {
    state.SkipWithError("the ffmpeg program could not make the recording");
    return;
  }
  for (auto _ : state) {
    FrameReader reader{recording.file(), {.height = 720, .span = {}}};
    Image reuse;
    while (auto frame = reader.next(std::move(reuse))) {
      benchmark::DoNotOptimize(frame->image.pixels.data());
      reuse = std::move(frame->image);
    }
  }
  report(state);
}

BENCHMARK_CAPTURE(read_all_frames, of_h264, ".mp4", "-c:v libx264 -b:v 4M -c:a aac")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(read_all_frames, of_mpeg2, ".mpg", "-c:v mpeg2video -b:v 6M -bf 2 -c:a mp2")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(read_all_frames,
                  of_interlaced_mpeg2,
                  "i.mpg",
                  "-c:v mpeg2video -b:v 6M -bf 2 -flags +ildct+ilme -top 1 -c:a mp2")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void read_the_sound(benchmark::State& state) {
  const Recording recording{"s.mp4", "-c:v libx264 -b:v 4M -c:a aac"};
  if (!recording.made()) {
    state.SkipWithError("the ffmpeg program could not make the recording");
    return;
  }
  for (auto _ : state) benchmark::DoNotOptimize(read_sound_track(recording.file()));
  report(state);
}

BENCHMARK(read_the_sound)->Unit(benchmark::kMillisecond);

/// Two seconds of sound, twice as fast.
void change_the_rate(benchmark::State& state) {
  Clip sound{Hertz{48'000}, std::vector<float>(96'000)};
  for (std::size_t i = 0; i < sound.samples.size(); ++i) {
    sound.samples[i] = static_cast<float>(i % 240) / 480.0F;
  }
  for (auto _ : state) benchmark::DoNotOptimize(change_rate(sound, 2.0));
}

BENCHMARK(change_the_rate)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bimodal
