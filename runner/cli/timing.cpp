#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "runner/cli/calibration.hpp"
#include "runner/cli/instruments.hpp"
#include "runner/cli/interrupt.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/cli/session_setup.hpp"
#include "runner/cli/timing_report.hpp"
#include "runner/cli/timing_run.hpp"
#include "runner/cli/verbs.hpp"
#include "runner/devices/device_error.hpp"
#include "runner/devices/monotonic_clock.hpp"
#include "runner/devices/portaudio/portaudio_input.hpp"
#include "runner/devices/portaudio/portaudio_output.hpp"
#include "runner/devices/right_of_way.hpp"
#include "runner/devices/sdl/sdl_display.hpp"
#include "runner/devices/sdl/sdl_keyboard.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

struct TimingOptions {
  int trials = 100;
  double av_offset_ms = 0.0;
  std::string audio = "default";
  std::string input;
  int photodiode = 1;
  int loopback = 2;
  double input_delay_ms = 0.0;
  std::string calibration;
  std::string output;
  bool windowed = false;
  int width = 1280;
  int height = 1024;
};

/// The devices, in the order in which they must be closed.
struct Bench {
  MonotonicClock clock;
  RightOfWay right_of_way;
  std::unique_ptr<SdlWindow> window;
  std::unique_ptr<SdlDisplay> display;
  std::unique_ptr<SdlKeyboard> keyboard;
  std::unique_ptr<PortaudioOutput> audio;
  std::unique_ptr<PortaudioInput> input;
  std::unique_ptr<Instruments> instruments;
};

Duration from_ms(double milliseconds) {
  return Duration{std::llround(milliseconds * 1e6)};
}

std::string named(const std::string& device) {
  return device == "default" ? std::string{} : device;
}

void open(Bench& bench, const TimingOptions& options) {
  bench.window =
      std::make_unique<SdlWindow>(SdlWindow::Options{.width = options.width,
                                                     .height = options.height,
                                                     .fullscreen = !options.windowed,
                                                     .title = "bimodal timing",
                                                     .background = {0.38F, 0.38F, 0.38F}});
  bench.display = std::make_unique<SdlDisplay>(*bench.window);
  bench.right_of_way.keep_to_itself();
  bench.keyboard = std::make_unique<SdlKeyboard>(*bench.window, bench.clock);
  bench.audio = std::make_unique<PortaudioOutput>(PortaudioOptions{.device = named(options.audio)});
  if (options.input.empty()) return;
  const auto channels = static_cast<std::size_t>(std::max(options.photodiode, options.loopback));
  bench.input = std::make_unique<PortaudioInput>(PortaudioInputOptions{
      .device = named(options.input), .channels = channels, .is_measuring = true});
  bench.instruments = std::make_unique<Instruments>(
      *bench.input,
      Instruments::Options{.photodiode = static_cast<std::size_t>(options.photodiode - 1),
                           .loopback = static_cast<std::size_t>(options.loopback - 1),
                           .delay = from_ms(options.input_delay_ms)});
}

TimingFindings measure(Bench& bench, const TimingOptions& options) {
  const Booth booth{bench.clock, *bench.display, *bench.keyboard, *bench.audio};
  const TimingPlan plan{.trials = options.trials,
                        .flash = {.drawing_rate = drawing_rate_for(bench.display->refresh().period),
                                  .av_offset = from_ms(options.av_offset_ms)}};
  TimingFindings findings{.made_utc = utc_now(),
                          .display = bench.display->description(),
                          .audio = bench.audio->description(),
                          .input = bench.input ? bench.input->description() : std::string{},
                          .right_of_way = bench.right_of_way.description(),
                          .gate = judge(bench.display->start_up()),
                          .intended = plan.flash.av_offset};
  const Screen dark;
  const auto rest = [&] { static_cast<void>(booth.display.present(dark, booth.clock.now())); };
  const auto after = [&](int index, TimedTrial& trial) {
    if (bench.instruments) bench.instruments->find(trial, rest);
    if ((index + 1) % 10 != 0) return;
    fmt::print(stderr, "\r{} of {} trials", index + 1, options.trials);
    std::fflush(stderr);
  };
  findings.trials = run_timing(booth, plan, after, interrupt_asked);
  fmt::print(stderr, "\n");
  if (bench.instruments) findings.input_lost = bench.instruments->lost();
  return findings;
}

/// Before anything is measured.
void make_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) {
    throw Error{fmt::format(
        "cannot make the folder '{}': {}; give another by -o", folder.string(), failure.message())};
  }
}

void write_files(const TimingFindings& findings, const std::filesystem::path& folder) {
  write_file(folder / "timing.json", as_json(findings));
  write_file(folder / "timing.html", as_page(findings));
  fmt::print("\n{}\n", (folder / "timing.html").string());
}

/// Refuses what was not measured well enough to correct a session by.
void keep_calibration(const TimingFindings& findings, const TimingOptions& options) {
  const auto summary = summarise(findings);
  constexpr std::size_t kFewest = 20;
  if (findings.input_lost > 0 || summary.measured.count < kFewest ||
      summary.unmeasured > summary.measured.count / 20) {
    throw Error{fmt::format(
        "the calibration is not kept: {} trials were measured, {} were not, {} samples lost; at "
        "least {} and hardly any others are needed; look at timing.html (-o), mend, and run again",
        summary.measured.count,
        summary.unmeasured,
        findings.input_lost,
        kFewest)};
  }
  const auto file = calibration_file(options.calibration);
  write_calibration({.name = options.calibration,
                     .made_utc = findings.made_utc,
                     .display = findings.display,
                     .audio = findings.audio,
                     .input = findings.input,
                     .offset = summary.measured,
                     .visual = summary.visual,
                     .auditory = summary.auditory},
                    file);
  fmt::print("kept as {}: `bimodal run ... --calibration {}` plays sound {:+.3f} ms earlier\n",
             file.string(),
             options.calibration,
             summary.measured.mean_ms);
}

ExitCode time(const TimingOptions& options) {
  if (!options.input.empty() && options.photodiode == options.loopback) {
    throw Error{
        fmt::format("photodiode and cable are both on channel {} of the input; give each its "
                    "own by --photodiode and --loopback",
                    options.loopback)};
  }
  if (!options.calibration.empty()) {
    if (options.input.empty()) {
      throw Error{
          "a calibration needs instruments; give the sound input that has the photodiode and the "
          "cable by --input (see `bimodal devices`)"};
    }
    static_cast<void>(calibration_file(options.calibration));
  }
  if (!options.output.empty()) make_folder(options.output);
  auto bench = std::make_unique<Bench>();
  open(*bench, options);
  stop_at_interrupt();
  const auto findings = measure(*bench, options);
  bench.reset();
  fmt::print("{}", as_text(findings));
  if (!options.output.empty()) write_files(findings, options.output);
  if (!options.calibration.empty()) keep_calibration(findings, options);
  return findings.gate.verdict == TimingVerdict::NotForTiming ? ExitCode::Findings : ExitCode::Done;
}

}  // namespace

void add_timing(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "timing",
      "Measures how this machine times flashes and beeps, by the presenter of every session: what\n"
      "the computer says and, with a photodiode on the left half of the flash and a cable from "
      "the\n"
      "sound output on a sound input, what really came. Ends with 1 if the screen is not for "
      "timing.\n\n"
      "Examples:\n"
      "  bimodal timing                            # what the computer says of itself\n"
      "  bimodal timing --trials 500 -o booth-1    # and timing.html, timing.json in a folder\n"
      "  bimodal timing --input \"USB Audio\" --photodiode 1 --loopback 2 --calibration booth-1\n"
      "  bimodal run words414 --participant P01 --calibration booth-1");
  auto options = std::make_shared<TimingOptions>();
  verb->add_option("--trials", options->trials, "flashes with their beeps (100)")
      ->check(whole_number_from(2));
  verb->add_option("--av-offset-ms", options->av_offset_ms, "intended, audio minus visual (0)")
      ->check(CLI::Range(-150.0, 150.0));
  verb->add_option("--audio", options->audio, "a device's name or number (see `bimodal devices`)");
  auto* const input = verb->add_option(
      "--input", options->input, "sound input with photodiode and cable, or default");
  verb->add_option("--photodiode", options->photodiode, "its channel of the input (1)")
      ->needs(input)
      ->check(whole_number_from(1));
  verb->add_option("--loopback", options->loopback, "the channel with the cable (2)")
      ->needs(input)
      ->check(whole_number_from(1));
  verb->add_option("--input-delay-ms",
                   options->input_delay_ms,
                   "what reaches the input comes so late, light and sound alike (0)")
      ->needs(input)
      ->check(CLI::Range(0.0, 1000.0));
  verb->add_option("--calibration", options->calibration, "keeps what was measured under this name")
      ->check(name_that_is_not_empty());
  verb->add_option("-o,--output", options->output, "folder for timing.json and timing.html");
  verb->add_flag("--windowed", options->windowed, "a window instead of the whole screen");
  verb->add_option("--width", options->width, "of the window, pixels (1280)")
      ->check(whole_number_from(512));
  verb->add_option("--height", options->height, "of the window, pixels (1024)")
      ->check(whole_number_from(512));
  verb->callback([options, &chosen] { chosen = [options] { return time(*options); }; });
}

}  // namespace bimodal::runner
