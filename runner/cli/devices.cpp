#include <fmt/format.h>

#include "runner/cli/verbs.hpp"
#include "runner/devices/portaudio/portaudio_output.hpp"

namespace bimodal::runner {

namespace {

ExitCode list_devices(bool only_ask_for_sound) {
  const auto sounds = describe_audio_devices();
  if (only_ask_for_sound) return sounds.empty() ? ExitCode::Findings : ExitCode::Done;
  if (sounds.empty()) {
    fmt::print("no sound device was found; use `run --audio none`, or start a sound server\n");
    return ExitCode::Findings;
  }
  fmt::print("sound devices for `run --audio`:\n");
  for (const auto& device : sounds) fmt::print("  {}\n", device);
  return ExitCode::Done;
}

}  // namespace

void add_devices(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand("devices", "Lists the sound devices of this machine.");
  auto has_sound = std::make_shared<bool>(false);
  verb->add_flag("--has-sound", *has_sound, "print nothing; exit 0 if there is one, else 1");
  verb->callback(
      [has_sound, &chosen] { chosen = [has_sound] { return list_devices(*has_sound); }; });
}

}  // namespace bimodal::runner
