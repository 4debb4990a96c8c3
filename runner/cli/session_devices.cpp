#include "runner/cli/session_devices.hpp"

#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "runner/booth/participant_screens.hpp"
#include "runner/booth/patch.hpp"
#include "runner/booth/visual_line.hpp"
#include "runner/cli/calibration.hpp"
#include "runner/cli/session_triggers.hpp"
#include "runner/cli/simulated_answers.hpp"
#include "runner/cli/timing_json.hpp"
#include "runner/devices/device_error.hpp"
#include "runner/devices/headless/headless_display.hpp"
#include "runner/devices/portaudio/portaudio_output.hpp"
#include "runner/devices/sdl/sdl_display.hpp"
#include "runner/devices/sdl/sdl_keyboard.hpp"
#include "runner/devices/silent/silent_audio.hpp"
#include "runner/devices/simulated/simulated_keyboard.hpp"
#include "runner/preparation/sound_channels.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

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

void open_screen(SessionDevices& devices,
                 const protocols::Protocol& protocol,
                 const DeviceChoice& choice) {
  if (choice.display != "headless") {
    devices.right_of_way.emplace();
    devices.window = std::make_unique<SdlWindow>(window_options(protocol, choice.windowed));
  }
  const auto patch = patch_for(protocol, devices.window.get());
  if (!devices.window) {
    devices.screen = std::make_unique<HeadlessDisplay>();
    devices.gate = {.reasons = {"nothing is shown"}};
  } else {
    auto screen = std::make_unique<SdlDisplay>(*devices.window, opening_screen(protocol, patch));
    devices.right_of_way->keep_to_itself();
    devices.gate = judge(screen->start_up());
    devices.screen = std::move(screen);
  }
  if (patch) {
    devices.display = std::make_unique<PatchedDisplay>(*devices.screen, *patch);
  } else {
    devices.display = std::move(devices.screen);
  }
}

void open_rest(SessionDevices& devices,
               const protocols::Protocol& protocol,
               const DeviceChoice& choice) {
  if (choice.simulated_answers || !devices.window) {
    devices.keyboard =
        std::make_unique<SimulatedKeyboard>(devices.clock, simulated_typist(protocol));
  } else {
    devices.keyboard = std::make_unique<SdlKeyboard>(*devices.window, devices.clock);
  }
  if (choice.audio == "none") {
    devices.audio = std::make_unique<SilentAudio>(devices.clock, protocol.sound.rate);
  } else {
    devices.audio = std::make_unique<PortaudioOutput>(
        PortaudioOptions{.device = choice.audio == "default" ? "" : choice.audio,
                         .rate = protocol.sound.rate,
                         .channels = channels_needed(protocol)});
  }
}

/// Throws Error if the calibration was made with another screen or sound output.
Calibration calibration_for(const SessionDevices& devices, const std::string& name) {
  const auto file = calibration_file(name);
  auto calibration = read_calibration(file);
  const auto refuse = [&](std::string_view what, const std::string& then, const std::string& now) {
    if (device_part(then) == device_part(now)) return;
    throw Error{fmt::format(
        "the calibration '{}' was made with another {} ('{}'; here it is '{}'); make one for this "
        "by `bimodal timing --input DEVICE --calibration NAME`, or leave --calibration out",
        file.string(),
        what,
        device_part(then),
        device_part(now))};
  };
  refuse("screen", calibration.display, devices.display->description());
  refuse("sound output", calibration.audio, devices.audio->description());
  return calibration;
}

std::string gate_text(const SessionDevices& devices) {
  auto json = as_json(devices.gate);
  if (devices.right_of_way) json["right_of_way"] = devices.right_of_way->description();
  return json.dump();
}

void settle_timing(SessionDevices& devices, const DeviceChoice& choice) {
  devices.timing = {.verdict = std::string{name(devices.gate.verdict)},
                    .gate = gate_text(devices),
                    .visual_line = "first"};
  if (choice.calibration.empty()) return;
  const auto calibration = calibration_for(devices, choice.calibration);
  devices.timing.calibration = as_text(calibration);
  devices.timing.visual_line = "calibrated";
  devices.reference.sound_after = Duration{std::llround(calibration.offset.mean_ms * 1e6)};
}

/// Asks on the screen itself, which may cover every terminal.
bool goes_on_all_the_same(SessionDevices& devices) {
  Screen question;
  question.captions = {
      {.text = fmt::format("This screen is not for timing:\n{}.\n\nEnter: go on all the same, the "
                           "verdict is stored.\nEscape: stop here.",
                           fmt::join(devices.gate.reasons, ";\n")),
       .centre_y = 0.45,
       .size = 0.03}};
  while (true) {
    static_cast<void>(devices.display->present(question, devices.clock.now()));
    for (const auto& stroke : devices.keyboard->poll()) {
      if (stroke.key == Key::Enter) return true;
      if (asks_to_stop(stroke)) return false;
    }
  }
}

}  // namespace

std::unique_ptr<SessionDevices> open_session_devices(const protocols::Protocol& protocol,
                                                     const DeviceChoice& choice) {
  if (!choice.calibration.empty()) {  // before anything shows
    static_cast<void>(read_calibration(calibration_file(choice.calibration)));
  }
  auto devices = std::make_unique<SessionDevices>();
  devices->trigger_lines = open_trigger_lines(protocol.triggers);
  open_screen(*devices, protocol, choice);
  open_rest(*devices, protocol, choice);
  settle_timing(*devices, choice);
  return devices;
}

void settle_visual_line(SessionDevices& devices,
                        const protocols::Protocol& protocol,
                        const std::map<std::string, Corpus>& corpora) {
  if (!devices.timing.calibration.empty()) return;
  const auto height = devices.window ? devices.window->size().height : protocol.window.height;
  const auto line = visual_line_of(protocol, corpora, height, devices.display->refresh().period);
  devices.timing.visual_line = line.name;
  devices.timing.visual_line_after = line.after;
  devices.reference.line_after = line.after;
}

Booth booth_of(SessionDevices& devices) {
  return {.clock = devices.clock,
          .display = *devices.display,
          .keyboard = *devices.keyboard,
          .audio = *devices.audio,
          .trigger_lines = borrowed(devices.trigger_lines),
          .reference = devices.reference};
}

bool may_go_on(SessionDevices& devices, bool strict, bool ask) {
  if (!devices.window && strict) {
    throw DeviceError{"there is no screen whose timing --strict could judge; leave it out"};
  }
  if (!devices.window) return true;
  const auto& gate = devices.gate;
  fmt::print(
      "screen: {}{}\n",
      gate.verdict == TimingVerdict::NotForTiming ? "not for timing" : name(gate.verdict),
      gate.reasons.empty() ? std::string{} : fmt::format(": {}", fmt::join(gate.reasons, "; ")));
  std::fflush(stdout);
  if (gate.verdict != TimingVerdict::NotForTiming) return true;
  if (strict) {
    throw DeviceError{fmt::format(
        "the screen is not for timing ({}), and --strict refuses it; close other programs, use a "
        "screen without compositor, or leave --strict out (`bimodal timing` tells more)",
        fmt::join(gate.reasons, "; "))};
  }
  return !ask || goes_on_all_the_same(devices);
}

}  // namespace bimodal::runner
