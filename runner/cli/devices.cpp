#include <fmt/format.h>

#include "runner/cli/verbs.hpp"
#include "runner/devices/portaudio/portaudio_input.hpp"
#include "runner/devices/portaudio/portaudio_output.hpp"
#include "runner/devices/serial/serial_line.hpp"

namespace bimodal::runner {

namespace {

void list_microphones() {
  const auto microphones = describe_microphones();
  if (microphones.empty()) return;
  fmt::print("microphones for `corpus record --device`:\n");
  for (const auto& device : microphones) fmt::print("  {}\n", device);
}

void list_serial_ports() {
  const auto ports = describe_serial_ports();
  if (ports.empty()) return;
  fmt::print("serial ports for triggers:\n");
  for (const auto& port : ports) fmt::print("  {}\n", port);
}

ExitCode list_devices(bool only_ask_for_sound) {
  const auto sounds = describe_audio_devices();
  if (only_ask_for_sound) return sounds.empty() ? ExitCode::Findings : ExitCode::Done;
  if (sounds.empty()) {
    fmt::print("no sound device was found; use `run --audio none`, or start a sound server\n");
    list_microphones();
    list_serial_ports();
    return ExitCode::Findings;
  }
  fmt::print("sound devices for `run --audio`:\n");
  for (const auto& device : sounds) fmt::print("  {}\n", device);
  list_microphones();
  list_serial_ports();
  return ExitCode::Done;
}

}  // namespace

void add_devices(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "devices", "Lists the sound devices, microphones and serial ports of this machine.");
  auto has_sound = std::make_shared<bool>(false);
  verb->add_flag("--has-sound", *has_sound, "print nothing; exit 0 if there is one, else 1");
  verb->callback(
      [has_sound, &chosen] { chosen = [has_sound] { return list_devices(*has_sound); }; });
}

}  // namespace bimodal::runner
