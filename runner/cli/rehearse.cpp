#include <cstdio>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

#include "runner/booth/session_loop.hpp"
#include "runner/cli/media_check.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/cli/protocol_file.hpp"
#include "runner/cli/session_level.hpp"
#include "runner/cli/session_setup.hpp"
#include "runner/cli/simulated_answers.hpp"
#include "runner/cli/verbs.hpp"
#include "runner/devices/simulated/simulated_audio.hpp"
#include "runner/devices/simulated/simulated_display.hpp"
#include "runner/devices/simulated/simulated_keyboard.hpp"
#include "runner/devices/simulated/virtual_clock.hpp"
#include "runner/preparation/timeless_trials.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

struct RehearseOptions {
  ProtocolChoice protocol;
  int participants = 1;
  int first = 1;
  Seed seed = 1;
  std::string data;
  std::optional<int> trials;
  bool again = false;
  double refresh_hz = 60.0;
};

/// Everything that participants share.
struct Rehearsal {
  const protocols::ReadProtocol& read;
  const RehearseOptions& options;
  TrialPreparer& preparer;
  SessionStore& store;
  StoreWriter& writer;
};

/// Simulated participants are S01, S02, ...
std::string name_of(int participant) {
  return fmt::format("S{:02}", participant);
}

int rehearse_participant(const Rehearsal& rehearsal, protocols::SessionKey key) {
  const auto& protocol = rehearsal.read.protocol;
  const auto plan = shortened_plan(rehearsal.read, key, {.main_trials = rehearsal.options.trials});
  VirtualClock clock;
  SimulatedDisplay display{clock, {.rate = Hertz{rehearsal.options.refresh_hz}}};
  SimulatedKeyboard keyboard{clock, simulated_typist(protocol)};
  SimulatedAudio audio{clock, protocol.sound.rate};
  TimelessTrials trials{plan, [&rehearsal] {
                          return [&rehearsal](const protocols::PlannedTrial& trial,
                                              const Checkpoint& checkpoint) {
                            return rehearsal.preparer.prepare(trial, checkpoint);
                          };
                        }};
  const auto begin = [&](const RefreshEstimate& refresh) {
    auto record = session_record(rehearsal.read, name_of(key.participant_number), key);
    record.simulated_answers = true;
    record.simulated_time = true;
    record.observer = observer_name();
    record.display = record_of(display);
    record.audio = record_of(audio);
    record.refresh_period = refresh.period;
    record.refresh_deviation = refresh.deviation;
    record.refresh_count = refresh.count;
    const auto id = rehearsal.store.begin(record, plan_records(rehearsal.read, plan));
    if (rehearsal.options.trials) {
      rehearsal.store.add(id,
                          EventRecord{.at = clock.now().time_since_epoch(),
                                      .kind = "shortened",
                                      .detail = counted(plan.size(), "trial") + " by --trials"});
    }
    return id;
  };
  const auto outcome =
      run_session({.protocol = protocol,
                   .plan = plan,
                   .booth = {clock, display, keyboard, audio},
                   .trials = trials,
                   .store = rehearsal.writer,
                   .begin = begin,
                   .plan_record =
                       [&](const protocols::PlannedTrial& trial) {
                         return plan_records(rehearsal.read, {trial}).front();
                       },
                   .answer = simulated_answers(rehearsal.read, key, rehearsal.options.seed)});
  if (outcome.session) rehearsal.store.end(*outcome.session, "complete", utc_now());
  return outcome.trials;
}

int sessions_per_participant(const protocols::Protocol& protocol) {
  return protocol.assignment == protocols::Assignment::Once
             ? 1
             : static_cast<int>(protocol.conditions.size());
}

ExitCode rehearse(const RehearseOptions& options) {
  const auto read = load_protocol(options.protocol);
  if (!read) return ExitCode::InvalidInput;
  const auto media = check_media(*read, find_protocol(options.protocol.named).string());
  print(media);
  if (has_errors(media)) return ExitCode::InvalidInput;
  const auto data = options.data.empty()
                        ? "rehearsal-" + default_data_file(options.protocol.named).string()
                        : options.data;
  if (!options.again) {
    for (int i = 0; i < options.participants; ++i) {
      refuse_repetition(data,
                        name_of(options.first + i),
                        {.participant_number = options.first + i, .session_number = 1},
                        *read,
                        true);
    }
  }
  if (const auto level = unheard_level(read->protocol.sound); !level.text.empty()) {
    fmt::print("{}\n", level.text);
  }
  const auto store = open_sqlite_store(data);
  StoreWriter writer{*store};
  Repertoire repertoire{read->protocol.sound.rate, read->corpora};
  TrialPreparer preparer{
      read->protocol, repertoire, nullptr, drawing_rate_for(period_of(Hertz{options.refresh_hz}))};
  const Rehearsal rehearsal{*read, options, preparer, *store, writer};
  const bool to_terminal = isatty(STDERR_FILENO) == 1;
  int trials = 0;
  for (int participant = 0; participant < options.participants; ++participant) {
    if (to_terminal) {
      fmt::print(
          stderr, "\rrehearsing participant {} of {} ", participant + 1, options.participants);
    }
    for (int session = 1; session <= sessions_per_participant(read->protocol); ++session) {
      trials += rehearse_participant(
          rehearsal,
          {.participant_number = options.first + participant, .session_number = session});
    }
  }
  if (to_terminal) fmt::print(stderr, "\r{:40}\r", "");
  fmt::print("rehearsed {}, {}, in virtual time; stored as simulated in {}\n",
             counted(static_cast<std::size_t>(options.participants), "participant"),
             counted(static_cast<std::size_t>(trials), "trial"),
             data);
  const auto lists = static_cast<int>(read->protocol.conditions.size());
  if (read->protocol.assignment == protocols::Assignment::Once &&
      options.participants % lists != 0) {
    fmt::print(
        "note: the {} lists of words are met equally often by a multiple of {} participants\n",
        lists,
        lists);
  }
  return ExitCode::Done;
}

}  // namespace

void add_rehearse(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "rehearse",
      "Runs the very loop of `run` with simulated devices, in virtual time, with simulated\n"
      "observers, and stores everything, marked as simulated: to try a protocol and its analysis\n"
      "before anybody is invited. The observers know which phones are confused in a voice at an "
      "S/N\n"
      "and on a face, and where answers are chosen they choose among the labels by that; a rate, "
      "a\n"
      "gate, a reversal, a natural face, what of the face is hidden, another word or an ambiguous\n"
      "sound that is seen, and an account of coarticulation do not change their answers.\n\n"
      "Example:\n"
      "  bimodal rehearse words414 --participants 20 --seed 7 --data trial.sqlite");
  auto options = std::make_shared<RehearseOptions>();
  add_protocol_options(*verb, options->protocol);
  verb->add_option("--participants", options->participants, "how many (1)")
      ->check(whole_number_from(1));
  verb->add_option("--first", options->first, "number of the first participant (1)")
      ->check(whole_number_from(1));
  verb->add_option("--seed", options->seed, "of the observers' answers (1)")->check(seed_number());
  verb->add_option("--data", options->data, "the data file (rehearsal-PROTOCOL.sqlite here)");
  verb->add_option("--trials", options->trials, "only so many main trials a participant")
      ->check(whole_number_from(1));
  verb->add_flag(
      "--again", options->again, "although the data file has these participants already");
  verb->add_option(
          "--refresh-hz", options->refresh_hz, "refresh rate of the simulated display (60)")
      ->check(CLI::Range(10.0, 1000.0));
  verb->callback([options, &chosen] { chosen = [options] { return rehearse(*options); }; });
}

}  // namespace bimodal::runner
