#include <cmath>
#include <cstdio>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runner/cli/interrupt.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/cli/timing_run.hpp"
#include "runner/cli/verbs.hpp"
#include "runner/devices/monotonic_clock.hpp"
#include "runner/devices/portaudio/portaudio_output.hpp"
#include "runner/devices/right_of_way.hpp"
#include "runner/devices/sdl/sdl_display.hpp"
#include "runner/devices/sdl/sdl_keyboard.hpp"
#include "runner/timing/moments.hpp"
#include "stimuli/base/draft.hpp"

namespace bimodal::runner {

namespace {

struct TimingOptions {
  int trials = 100;
  std::string audio = "default";
  std::string json;
  bool windowed = false;
  int width = 1280;
  int height = 1024;
  double av_offset_ms = 0.0;
};

nlohmann::json as_json(const TimedTrial& trial) {
  nlohmann::json json{{"trial", trial.record.trial}, {"flagged", trial.record.flagged}};
  const auto number = [](const std::optional<Duration>& at) {
    return at ? nlohmann::json(at->count()) : nlohmann::json();
  };
  json["visual_ns"] = number(trial.visual);
  json["auditory_ns"] = number(trial.auditory);
  for (const auto& onset : trial.record.onsets) {
    json["planned"][onset.modality] = onset.planned.count();
    json["source"][onset.modality] = onset.source;
  }
  for (const auto& event : trial.record.events) {
    json["events"].push_back(event.kind + ": " + event.detail);
  }
  json["frames"] = trial.record.refreshes.frame;
  for (const auto shown : trial.record.refreshes.shown) {
    json["shown_ns"].push_back(shown.count());
  }
  return json;
}

ExitCode measure(const TimingOptions& options) {
  MonotonicClock clock;
  const RightOfWay right_of_way;
  SdlWindow window{{.width = options.width,
                    .height = options.height,
                    .fullscreen = !options.windowed,
                    .title = "bimodal timing",
                    .background = {0.38F, 0.38F, 0.38F}}};
  SdlDisplay display{window};
  right_of_way.keep_to_itself();
  SdlKeyboard keyboard{window, clock};
  PortaudioOutput audio{{.device = options.audio == "default" ? "" : options.audio}};
  fmt::print("{}\n{}\n", display.description(), audio.description());
  const TimingPlan plan{.trials = options.trials,
                        .flash = {.drawing_rate = drawing_rate_for(display.refresh().period),
                                  .av_offset = Duration{std::llround(options.av_offset_ms * 1e6)}}};
  stop_at_interrupt();
  const auto trials = run_timing(
      {clock, display, keyboard, audio}, plan, [](int, TimedTrial&) {}, interrupt_asked);
  std::vector<Duration> offsets;
  int flagged = 0;
  for (const auto& trial : trials) {
    flagged += trial.record.flagged ? 1 : 0;
    if (!trial.record.flagged && trial.visual && trial.auditory) {
      offsets.push_back(*trial.auditory - *trial.visual);
    }
  }
  const auto moments = moments_of(offsets);
  fmt::print("{} trials, {} flagged; reported offset {:+.3f} ms, SD {:.3f}\n{}",
             trials.size(),
             flagged,
             moments.mean_ms,
             moments.deviation_ms,
             draw(histogram_of(offsets)));
  if (!options.json.empty()) {
    nlohmann::json json;
    for (const auto& trial : trials) json["trials"].push_back(as_json(trial));
    auto* const file = std::fopen(options.json.c_str(), "w");
    fmt::print(file, "{}\n", json.dump());
    std::fclose(file);
  }
  return ExitCode::Done;
}

}  // namespace

void add_timing(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand("timing", "Measures how flashes and beeps are timed.");
  auto options = std::make_shared<TimingOptions>();
  verb->add_option("--trials", options->trials, "how many")->check(whole_number_from(1));
  verb->add_option("--audio", options->audio, "device");
  verb->add_option("--json", options->json, "file");
  verb->add_option("--av-offset-ms", options->av_offset_ms, "audio minus visual, intended");
  verb->add_flag("--windowed", options->windowed, "a window");
  verb->add_option("--width", options->width, "pixels");
  verb->add_option("--height", options->height, "pixels");
  verb->callback([options, &chosen] { chosen = [options] { return measure(*options); }; });
}

}  // namespace bimodal::runner
