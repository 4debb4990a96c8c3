#include "runner/cli/render_files.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "runner/cli/interrupt.hpp"
#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/picture/drawing.hpp"
#include "stimuli/picture/image.hpp"
#include "stimuli/video/picture_queue.hpp"
#include "stimuli/video/video_writer.hpp"
#include "synth/render/head_renderer.hpp"

namespace bimodal::runner {

namespace {

constexpr Milliseconds kLongestFilm = std::chrono::hours{1};
constexpr std::size_t kWidestStrip = 65'500;  ///< pixels; many programs show no more

/// "frame 12 of 90" on a terminal, for work that can be stopped.
class Progress {
 public:
  explicit Progress(std::int64_t count) : count_{count} {}

  ~Progress() {
    if (is_told_) fmt::print(stderr, "\r{:40}\r", "");
  }

  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;

  /// `left`: what an interruption leaves of the output, "not written" or "not complete".
  void begin(std::int64_t number, std::string_view name, std::string_view left) const {
    if (interrupt_asked()) throw Error{fmt::format("stopped; '{}' is {}", name, left)};
    if (is_told_) fmt::print(stderr, "\rframe {} of {} ", number + 1, count_);
  }

 private:
  std::int64_t count_;
  bool is_told_ = isatty(STDERR_FILENO) == 1;
};

/// As long as the face moves or something is heard.
Milliseconds length_of(const SeenSpeech& seen, const Clip* sound) {
  const Milliseconds heard = sound == nullptr ? Milliseconds{} : Milliseconds{sound->duration()};
  const auto length = std::max(seen.end, heard);
  if (length > kLongestFilm) {
    throw Error{fmt::format("it would last {:.0f} minutes; films last an hour at most",
                            length.count() / 60'000)};
  }
  return length;
}

void write_film(const RenderOutput& output,
                const SeenSpeech& seen,
                const Clip* sound,
                synth::HeadRenderer& renderer,
                const RenderStyle& style) {
  const auto rate = rate_in(*output.form, style.rate);
  const auto frames = rate.frames_before(length_of(seen, sound));
  const auto most = most_frames(*output.form, style.view.width, style.view.height);
  if (frames > most) {
    throw Error{fmt::format(
        "cannot write '{}': it would have {} frames of {} x {} pixels, and a GIF of this size {} "
        "at most; make it smaller (--height), take fewer (--fps), or write .mp4 or .webm",
        output.name,
        frames,
        style.view.width,
        style.view.height,
        most)};
  }
  VideoWriter video{output.name,
                    {.width = style.view.width,
                     .height = style.view.height,
                     .rate = rate,
                     .rate_factor = style.rate_factor,
                     .sound = sound}};
  Image picture;
  {
    const Progress progress{frames};
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      progress.begin(frame, output.name, "not written");
      renderer.draw(seen.pose(rate.time_of(frame)), picture);
      video.add(picture);
    }
    video.finish();
  }
  fmt::print("{}: {} of {} x {} pixels, {} a second{}{}\n",
             output.name,
             counted(static_cast<std::size_t>(frames), "frame"),
             style.view.width,
             style.view.height,
             describe(rate),
             rate == style.rate ? ""
                                : fmt::format(" (not {}: frames of this form last whole hundredths "
                                              "of a second, at least two)",
                                              describe(style.rate)),
             sound == nullptr ? "" : ", with sound");
}

void write_frames(const RenderOutput& output,
                  const SeenSpeech& seen,
                  synth::HeadRenderer& renderer,
                  const RenderStyle& style) {
  const auto frames = style.rate.frames_before(length_of(seen, nullptr));
  std::int64_t written = 0;
  PictureQueue writing{[&](const Image& picture) {
    write_png(picture, output.frame_file(written++), Packing::Fast);
  }};
  {
    const Progress progress{frames};
    Image picture;
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      progress.begin(frame, output.name, "not complete");
      renderer.draw(seen.pose(style.rate.time_of(frame)), picture);
      writing.add(picture);
    }
    writing.finish();
  }
  fmt::print("{}: {}, {} a second\n",
             output.name,
             counted(static_cast<std::size_t>(frames), "frame"),
             describe(style.rate));
  const auto next = output.frame_file(frames);
  if (std::filesystem::exists(next)) {
    fmt::print(stderr, "note: {} and what follows are of an earlier film\n", next.string());
  }
}

void write_strip(const RenderOutput& output,
                 const SeenSpeech& seen,
                 synth::HeadRenderer& renderer,
                 const RenderStyle& style) {
  const auto& centres = seen.centres;
  if (centres.empty()) {
    throw Error{
        fmt::format("cannot write '{}': these tracks do not tell where segments are; give an "
                    "instant, e.g. --at "
                    "{:.0f}, or write a film",
                    output.name,
                    seen.end.count() / 2)};
  }
  const auto width = style.view.width * centres.size();
  if (width > kWidestStrip) {
    throw Error{
        fmt::format("cannot write '{}': {} pictures of {} pixels would be too wide side by "
                    "side; make them smaller (--height), or write a film",
                    output.name,
                    centres.size(),
                    style.view.width)};
  }
  auto strip = blank_image(width, style.view.height, {});
  Image picture;
  const Progress progress{static_cast<std::int64_t>(centres.size())};
  for (std::size_t i = 0; i < centres.size(); ++i) {
    progress.begin(static_cast<std::int64_t>(i), output.name, "not written");
    renderer.draw(seen.pose(centres[i].time), picture);
    paste(strip, {static_cast<std::int64_t>(i * style.view.width), 0}, picture);
  }
  write_png(strip, output.name);
  for (const auto& [symbol, time] : centres)
    fmt::print("  {:<5} {:>7.1f} ms\n", symbol, time.count());
  fmt::print("{}: {}, one at the centre of each segment\n",
             output.name,
             counted(centres.size(), "picture"));
}

}  // namespace

void write_rendered(const RenderOutput& output,
                    const SeenSpeech& seen,
                    const Clip* sound,
                    const synth::Head& head,
                    const RenderStyle& style) {
  using Kind = RenderOutput::Kind;
  if (output.kind == Kind::Sound) {
    write_wav(output.name, seen.sound.value());
    fmt::print("{}: {:.2f} s of the voice\n",
               output.name,
               std::chrono::duration<double>{seen.sound->duration()}.count());
    return;
  }
  synth::HeadRenderer renderer{head, style.view, style.appearance};
  if (output.kind == Kind::Film) {
    write_film(output, seen, output.has_sound() ? sound : nullptr, renderer, style);
  } else if (output.kind == Kind::Frames) {
    write_frames(output, seen, renderer, style);
  } else if (output.kind == Kind::Strip) {
    write_strip(output, seen, renderer, style);
  } else {
    Image picture;
    renderer.draw(seen.pose(style.instant.value()), picture);
    write_png(picture, output.name);
    fmt::print("{}: the face at {:g} ms\n", output.name, style.instant->count());
  }
}

}  // namespace bimodal::runner
