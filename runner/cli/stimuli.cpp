#include <optional>

#include <fmt/format.h>

#include "runner/cli/media_check.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/cli/protocol_file.hpp"
#include "runner/cli/session_setup.hpp"
#include "runner/cli/stimuli_strip.hpp"
#include "runner/cli/verbs.hpp"
#include "runner/preparation/trial_preparer.hpp"
#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

struct MixOptions {
  ProtocolChoice protocol;
  int trial = 1;
  std::string participant = "P01";
  std::optional<int> number;
  int session = 1;
  std::string output;
  std::optional<double> dbfs;
};

/// Where the protocol asks for dB SPL, the level depends on the device.
void settle_level(protocols::Sound& sound, std::optional<double> dbfs) {
  if (dbfs) sound.speech_level = Decibels{*dbfs};
  if (!sound.speech_spl || dbfs) return;
  throw Error{
      fmt::format("the protocol asks for speech of {:g} dB SPL, whose level re full scale depends "
                  "on the sound output; give it by --dbfs, e.g. speech_dbfs of table sound",
                  sound.speech_spl->count())};
}

ExitCode mix_trial(const MixOptions& options) {
  auto read = load_protocol(options.protocol);
  if (!read) return ExitCode::InvalidInput;
  settle_level(read->protocol.sound, options.dbfs);
  const auto media = check_media(*read, find_protocol(options.protocol.named).string());
  print(media);
  if (has_errors(media)) return ExitCode::InvalidInput;
  const auto plan = protocols::make_plan(
      read->protocol,
      read->words,
      read->practice,
      {.participant_number = participant_number(options.participant, options.number),
       .session_number = options.session});
  if (options.trial < 1 || options.trial > static_cast<int>(plan.size())) {
    throw Error{fmt::format("there is no trial {}; participant '{}' has trials 1 to {}",
                            options.trial,
                            options.participant,
                            plan.size())};
  }
  const auto& trial = plan.at(static_cast<std::size_t>(options.trial - 1));
  const auto& condition = read->protocol.conditions.at(trial.condition).name;
  Repertoire repertoire{read->protocol.sound.rate, read->corpora};
  TrialPreparer preparer{read->protocol, repertoire, nullptr, Hertz{60}};
  const auto mixed = preparer.mix_sound(trial);
  if (!mixed) {
    throw Error{fmt::format("trial {} (\"{}\") is in condition \"{}\", in which nothing is heard",
                            options.trial,
                            trial.word.spelling,
                            condition)};
  }
  const auto clipping = clipping_message(trial, condition, *mixed);
  if (!clipping.empty()) throw Error{clipping};
  write_wav(options.output, mixed->sound);
  fmt::print(
      "{}: trial {} (trial = {} in the data of a whole session), \"{}\" ({}), condition \"{}\"\n",
      options.output,
      options.trial,
      trial.index,
      trial.word.spelling,
      spell(trial.word.phones),
      condition);
  fmt::print("speech {:.2f} dB FS, noise {}, both in {:g}-{:g} Hz; peak {:.3f}; SHA-256 {}\n",
             mixed->speech_dbfs,
             mixed->noise_dbfs ? fmt::format("{:.2f} dB FS", *mixed->noise_dbfs) : "none",
             mixed->band.low.count(),
             mixed->band.high.count(),
             mixed->peak,
             sha256(mixed->sound));
  return ExitCode::Done;
}

}  // namespace

void add_stimuli(CLI::App& app, Verb& chosen) {
  auto* const stimuli = app.add_subcommand("stimuli", "Makes single stimuli as files.");
  stimuli->require_subcommand(1);
  add_stimuli_strip(*stimuli, chosen);
  auto* const mix = stimuli->add_subcommand(
      "mix",
      "Writes the very samples that `run` plays in a trial, as 32-bit float WAV.\n\n"
      "Example:\n  bimodal stimuli mix words414 --trial 20 -o trial20.wav");
  auto options = std::make_shared<MixOptions>();
  add_protocol_options(*mix, options->protocol);
  mix->add_option(
         "--trial",
         options->trial,
         "number of the trial, from 1, practice included: one more than `trial` in the data")
      ->required();
  mix->add_option("-o,--output", options->output, "the WAV file to be written")
      ->required()
      ->check(in_a_folder_that_exists());
  mix->add_option("--dbfs", options->dbfs, "level of the speech, where the protocol gives dB SPL")
      ->check(finite_number())
      ->check(CLI::Range(-80.0, 0.0));
  mix->add_option("--participant", options->participant, "whose trial (P01)");
  mix->add_option("--number", options->number, "the participant's number, if the name has none")
      ->check(whole_number_from(1));
  mix->add_option("--session", options->session, "number of the session (1)")
      ->check(whole_number_from(1));
  mix->callback([options, &chosen] { chosen = [options] { return mix_trial(*options); }; });
}

}  // namespace bimodal::runner
