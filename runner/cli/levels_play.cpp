#include <memory>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include "runner/calibration/calibration_sound.hpp"
#include "runner/cli/interrupt.hpp"
#include "runner/cli/levels_verbs.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/devices/monotonic_clock.hpp"
#include "runner/devices/portaudio/portaudio_output.hpp"
#include "runner/devices/silent/silent_audio.hpp"

namespace bimodal::runner {

namespace {

constexpr int kLookEveryMs = 50;
constexpr double kLongestSeconds = 600;

struct PlayOptions {
  LevelOptions level;
  double seconds = 60;
};

std::unique_ptr<AudioOutput> output_for(const LevelOptions& options, const Clock& clock) {
  const Hertz rate{static_cast<double>(options.rate_hz)};
  if (options.device == "none") return std::make_unique<SilentAudio>(clock, rate);
  return std::make_unique<PortaudioOutput>(PortaudioOptions{
      .device = options.device, .rate = rate, .channels = options.channel.value_or(0)});
}

/// Whether somebody has pressed Enter; looks for a little while. Where nobody can, it only waits.
bool enter_pressed() {
  const bool may_come = isatty(STDIN_FILENO) == 1;
  pollfd keys{.fd = may_come ? STDIN_FILENO : -1, .events = POLLIN, .revents = 0};
  return ::poll(&keys, 1, kLookEveryMs) > 0;
}

ExitCode play(const PlayOptions& options) {
  const auto& level = options.level;
  auto clip = made({.content = content_of(level),
                    .level = Decibels{level.dbfs},
                    .rate = Hertz{static_cast<double>(level.rate_hz)},
                    .length = std::chrono::duration_cast<Duration>(
                        std::chrono::duration<double>{options.seconds})});
  const MonotonicClock clock;
  const auto output = output_for(level, clock);
  Sound sound{.rate = clip.rate,
              .samples = std::make_shared<const std::vector<float>>(std::move(clip.samples))};
  if (level.channel) {
    sound.channels = ChannelSet{};
    sound.channels.add(static_cast<std::size_t>(*level.channel - 1));
  }
  fmt::print("{}; {}\nIt may be loud: put no headphones on. Enter or Ctrl-C ends it.\n",
             describe(level),
             output->description());
  std::fflush(stdout);
  stop_at_interrupt();
  output->schedule(sound, clock.now() + output->lead_time());
  while (!output->playback().finished && !interrupt_asked() && !enter_pressed()) {
  }
  output->stop();
  while (!output->playback().finished) static_cast<void>(enter_pressed());
  fmt::print("what was measured meanwhile is kept by `bimodal levels set`\n");
  return ExitCode::Done;
}

}  // namespace

void add_levels_play(CLI::App& levels, Verb& chosen) {
  auto* const verb = levels.add_subcommand(
      "play",
      "Plays noise of a band, or a tone, at a level re full scale (RMS, 0 dB: an RMS of 1) while\n"
      "you measure it at the ear, until Enter is pressed.\n\n"
      "Examples:\n"
      "  bimodal levels play --dbfs -30 --band 80-8000\n"
      "  bimodal levels play --dbfs -20 --tone 1000 --channel 1");
  auto options = std::make_shared<PlayOptions>();
  add_level_options(*verb, options->level);
  verb->add_option("--seconds", options->seconds, "how long at most (60)")
      ->check(finite_number())
      ->check(CLI::Range(0.2, kLongestSeconds));
  verb->callback([options, &chosen] { chosen = [options] { return play(*options); }; });
}

}  // namespace bimodal::runner
