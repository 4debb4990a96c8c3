#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "runner/booth/patch.hpp"
#include "runner/booth/session_loop.hpp"
#include "runner/cli/interrupt.hpp"
#include "runner/cli/media_check.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/cli/protocol_file.hpp"
#include "runner/cli/session_face.hpp"
#include "runner/cli/session_level.hpp"
#include "runner/cli/session_preparation.hpp"
#include "runner/cli/session_setup.hpp"
#include "runner/cli/session_triggers.hpp"
#include "runner/cli/simulated_answers.hpp"
#include "runner/cli/verbs.hpp"
#include "runner/devices/headless/headless_display.hpp"
#include "runner/devices/monotonic_clock.hpp"
#include "runner/devices/portaudio/portaudio_output.hpp"
#include "runner/devices/sdl/sdl_display.hpp"
#include "runner/devices/sdl/sdl_keyboard.hpp"
#include "runner/devices/silent/silent_audio.hpp"
#include "runner/devices/simulated/simulated_keyboard.hpp"
#include "runner/preparation/preparation_queue.hpp"
#include "runner/preparation/sound_channels.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

struct RunOptions {
  ProtocolChoice protocol;
  std::string participant;
  std::optional<int> number;
  int session = 1;
  std::string data;
  std::string display = "window";
  std::string audio = "default";
  std::string answers = "typed";
  std::optional<int> trials;
  bool no_practice = false;
  bool windowed = false;
  bool again = false;
  bool no_cache = false;
  bool no_triggers = false;
};

/// The devices of a real session, in the order in which they must be closed.
struct Devices {
  MonotonicClock clock;
  std::unique_ptr<SdlWindow> window;
  std::unique_ptr<Display> screen;
  std::unique_ptr<Display> display;  ///< the screen, with a patch if one is asked for
  std::unique_ptr<Keyboard> keyboard;
  std::unique_ptr<AudioOutput> audio;
  std::vector<std::unique_ptr<TriggerSender>> trigger_lines;
};

SdlWindow::Options window_options(const protocols::Protocol& protocol, bool windowed) {
  const auto channel = [&](unsigned shift) {
    return static_cast<float>((protocol.window.background >> shift) & 0xffU) / 255.0F;
  };
  return {.width = protocol.window.width,
          .height = protocol.window.height,
          .fullscreen = protocol.window.fullscreen && !windowed,
          .title = protocol.title,
          .background = {channel(16), channel(8), channel(0)}};
}

/// What is on the screen while the display is measured: the first page, so that nobody waits for
/// it.
Screen opening_screen(const protocols::Protocol& protocol, const std::optional<Patch>& patch) {
  auto screen =
      protocol.instructions.empty() ? Screen{} : page_screen(protocol.instructions.front());
  if (patch) screen.marks.push_back(patch->at_rest);
  return screen;
}

std::optional<Patch> patch_for(const protocols::Protocol& protocol, const SdlWindow* window) {
  const auto& photodiode = protocol.triggers.photodiode;
  if (!photodiode) return std::nullopt;
  const auto size = window != nullptr
                        ? window->size()
                        : SdlWindow::Size{protocol.window.width, protocol.window.height};
  return patch_of(*photodiode, size.width, size.height);
}

std::unique_ptr<Devices> open_devices(const protocols::Protocol& protocol,
                                      const RunOptions& options) {
  auto opened = std::make_unique<Devices>();
  auto& devices = *opened;
  devices.trigger_lines = open_trigger_lines(protocol.triggers);
  if (options.display != "headless") {
    devices.window = std::make_unique<SdlWindow>(window_options(protocol, options.windowed));
  }
  const auto patch = patch_for(protocol, devices.window.get());
  if (!devices.window) {
    devices.screen = std::make_unique<HeadlessDisplay>();
  } else {
    devices.screen = std::make_unique<SdlDisplay>(*devices.window, opening_screen(protocol, patch));
  }
  if (patch) {
    devices.display = std::make_unique<PatchedDisplay>(*devices.screen, *patch);
  } else {
    devices.display = std::move(devices.screen);
  }
  if (options.answers == "simulated" || !devices.window) {
    devices.keyboard = std::make_unique<SimulatedKeyboard>(devices.clock);
  } else {
    devices.keyboard = std::make_unique<SdlKeyboard>(*devices.window, devices.clock);
  }
  if (options.audio == "none") {
    devices.audio = std::make_unique<SilentAudio>(devices.clock, protocol.sound.rate);
  } else {
    devices.audio = std::make_unique<PortaudioOutput>(
        PortaudioOptions{.device = options.audio == "default" ? "" : options.audio,
                         .rate = protocol.sound.rate,
                         .channels = channels_needed(protocol)});
  }
  return opened;
}

/// A line on the console, if there is something to say.
void tell(std::string_view what) {
  if (what.empty()) return;
  fmt::print("{}\n", what);
  std::fflush(stdout);
}

void report_outcome(const SessionOutcome& outcome,
                    const std::vector<protocols::PlannedTrial>& plan,
                    const std::string& data) {
  fmt::print("{}: {} of {} trials stored in {}",
             outcome.complete ? "complete" : "stopped",
             outcome.trials,
             plan.size(),
             data);
  if (outcome.flagged == 0) {
    fmt::print("; timing as planned in all\n");
  } else {
    fmt::print("; timing flagged in {}, see table event\n", outcome.flagged);
  }
  if (!outcome.complete) {
    fmt::print("what was answered is kept; --again begins this session anew, beside it\n");
  }
}

void refuse_what_nobody_could_answer(const RunOptions& options) {
  if (options.display == "headless" && options.answers == "typed") {
    throw Error{
        "nobody can type answers without a window; give --answers simulated with --display "
        "headless"};
  }
}

/// Which triggers the session does without, because that is asked for; empty: none.
std::string leave_out_triggers(protocols::Protocol& protocol, bool asked) {
  return asked ? trigger_kinds(std::exchange(protocol.triggers, {})) : std::string{};
}

ExitCode run(const RunOptions& options) {
  refuse_what_nobody_could_answer(options);
  auto read = load_protocol(options.protocol);
  if (!read) return ExitCode::InvalidInput;
  const auto left_out = leave_out_triggers(read->protocol, options.no_triggers);
  const auto& protocol = read->protocol;
  const protocols::SessionKey key{
      .participant_number = participant_number(options.participant, options.number),
      .session_number = options.session};
  const auto plan =
      shortened_plan(*read, key, {.main_trials = options.trials, .practice = !options.no_practice});
  const auto media = check_media(*read, find_protocol(options.protocol.named).string());
  print(media);
  if (has_errors(media)) return ExitCode::InvalidInput;
  const auto data = options.data.empty() ? default_data_file(options.protocol.named)
                                         : std::filesystem::path{options.data};
  const bool simulated = options.answers == "simulated";
  if (!options.again) {
    refuse_repetition(data, options.participant, key, *read, simulated);
  }
  const auto face = examine_face(*read, plan, options.display != "headless" && !simulated);
  // A new file is made only when the devices are there; an old one is opened before anything shows.
  auto store = std::filesystem::exists(data) ? open_sqlite_store(data) : nullptr;
  if (!store) require_place_for(data);
  const auto devices = open_devices(protocol, options);
  const auto level = level_on(*devices->audio, read->protocol.sound);
  tell(level.text);
  if (!store) store = open_sqlite_store(data);
  StoreWriter writer{*store};
  if (options.display == "headless") fmt::print("no display: nothing is shown\n");
  if (options.audio == "none") fmt::print("no audio: nothing is heard\n");

  Repertoire repertoire{protocol.sound.rate, read->corpora};
  const auto drawing_rate = drawing_rate_for(devices->display->refresh().period);
  const auto quality = face ? quality_of(*face, protocol, drawing_rate) : ChosenQuality{};
  if (face) tell(describe(quality));
  PreparationQueue queue{plan, [&] {
                           return prepare_session({.read = *read,
                                                   .named = options.protocol.named,
                                                   .plan = plan,
                                                   .repertoire = repertoire,
                                                   .drawing_rate = drawing_rate,
                                                   .quality = quality,
                                                   .keeps_films = !options.no_cache,
                                                   .tell = tell});
                         }};
  const auto begin = [&](const RefreshEstimate& refresh) {
    auto record = session_record(*read, options.participant, key);
    record.simulated_answers = simulated;
    record.observer = simulated ? observer_name() : "";
    record.display = record_of(*devices->display);
    record.audio = record_of(*devices->audio);
    record.sound_levels = level.record;
    record.refresh_period = refresh.period;
    record.refresh_deviation = refresh.deviation;
    record.refresh_count = refresh.count;
    if (face) record.face = record_of(*face, quality);
    const auto id = store->begin(record, plan_records(*read, plan));
    const auto note = [&](const char* kind, std::string detail) {
      store->add(id, EventRecord{devices->clock.now().time_since_epoch(), kind, std::move(detail)});
    };
    if (options.trials || options.no_practice) {
      note("shortened", fmt::format("{} trials by --trials or --no-practice", plan.size()));
    }
    if (!left_out.empty()) note("no_triggers", left_out + " left out by --no-triggers");
    return id;
  };
  stop_at_interrupt();
  const auto outcome = run_session(
      {.protocol = protocol,
       .plan = plan,
       .booth = {devices->clock,
                 *devices->display,
                 *devices->keyboard,
                 *devices->audio,
                 borrowed(devices->trigger_lines)},
       .trials = queue,
       .store = writer,
       .begin = begin,
       .answer = simulated ? simulated_answers(protocol, key, protocol.seed) : Answers{},
       .interrupted = interrupt_asked,
       .announce = tell});
  if (outcome.session) {
    store->end(*outcome.session, outcome.complete ? "complete" : "stopped", utc_now());
  }
  report_outcome(outcome, plan, data.string());
  return ExitCode::Done;
}

}  // namespace

void add_run(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "run",
      "Runs a session with a participant: shows, plays, takes typed answers, stores every trial\n"
      "before the next begins. Escape asks whether to stop.\n\n"
      "Examples:\n"
      "  bimodal run words414 --participant P01\n"
      "  bimodal run words414 --participant TEST1 --trials 5 --no-practice --windowed\n"
      "  bimodal run words414 --participant P01 --display headless --audio none --answers "
      "simulated");
  auto options = std::make_shared<RunOptions>();
  add_protocol_options(*verb, options->protocol);
  verb->add_option("--participant", options->participant, "a name that ends with a number: P01")
      ->required();
  verb->add_option("--number", options->number, "the participant's number, if the name has none")
      ->check(whole_number_from(1));
  verb->add_option("--session", options->session, "number of the session (1)")
      ->check(whole_number_from(1));
  verb->add_option("--data", options->data, "the data file (PROTOCOL.sqlite here); appended to");
  verb->add_option("--display", options->display, "window (default) or headless: nothing is shown")
      ->check(CLI::IsMember({"window", "headless"}));
  verb->add_option("--audio",
                   options->audio,
                   "default, a device's name or number (see `bimodal devices`), or none");
  verb->add_option("--answers", options->answers, "typed (default), or simulated: stored as such")
      ->check(CLI::IsMember({"typed", "simulated"}));
  verb->add_option("--trials", options->trials, "only so many main trials, for trying out")
      ->check(whole_number_from(1));
  verb->add_flag("--no-practice", options->no_practice, "leave out the practice");
  verb->add_flag("--windowed", options->windowed, "a window, whatever the protocol says");
  verb->add_flag(
      "--no-cache",
      options->no_cache,
      "draws every film of the face, and keeps none in ~/.cache/bimodal ($BIMODAL_CACHE)");
  verb->add_flag("--no-triggers",
                 options->no_triggers,
                 "without the protocol's triggers, for trying out without the equipment");
  verb->add_flag("--again", options->again, "although this participant has this session already");
  verb->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace bimodal::runner
