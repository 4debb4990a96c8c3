#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "runner/booth/session_loop.hpp"
#include "runner/cli/interrupt.hpp"
#include "runner/cli/media_check.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/cli/protocol_file.hpp"
#include "runner/cli/resumption.hpp"
#include "runner/cli/session_beginning.hpp"
#include "runner/cli/session_devices.hpp"
#include "runner/cli/session_face.hpp"
#include "runner/cli/session_level.hpp"
#include "runner/cli/session_preparation.hpp"
#include "runner/cli/session_report.hpp"
#include "runner/cli/session_setup.hpp"
#include "runner/cli/session_triggers.hpp"
#include "runner/cli/simulated_answers.hpp"
#include "runner/cli/sound_return.hpp"
#include "runner/cli/verbs.hpp"
#include "runner/cli/watched_session.hpp"
#include "runner/devices/device_error.hpp"
#include "runner/preparation/preparation_queue.hpp"
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
  bool strict = false;
  bool resume = false;
  std::string calibration;
};

/// A line on the console, if there is something to say.
void tell(std::string_view what) {
  if (what.empty()) return;
  fmt::print("{}\n", what);
  std::fflush(stdout);
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

/// An earlier part of this session, if it is to go on; else refuses to repeat one.
std::optional<Resumption> earlier_part(const RunOptions& options,
                                       const std::filesystem::path& data,
                                       protocols::SessionKey key,
                                       const protocols::ReadProtocol& read,
                                       const std::vector<protocols::PlannedTrial>& plan) {
  if (options.resume) return find_resumption(data, options.participant, key, read, plan);
  const bool simulated = options.answers == "simulated";
  if (!options.again) refuse_repetition(data, options.participant, key, read, simulated);
  return std::nullopt;
}

void tell_what_is_left_out(const RunOptions& options) {
  if (options.display == "headless") fmt::print("no display: nothing is shown\n");
  if (options.audio == "none") fmt::print("no audio: nothing is heard\n");
}

/// Refuses to go on otherwise than the session began; says, and returns, whether trials that were
/// owed to the participant are not presented again.
bool goes_on(const std::optional<Resumption>& earlier,
             const SessionRecord& record,
             const protocols::Protocol& protocol) {
  if (!earlier) return false;
  require_same_terms(*earlier, record);
  if (earlier->owed.empty() || protocol.timing.flagged != protocols::Flagged::Repeat) return false;
  tell(fmt::format("trials flagged before that are not presented again: {}", earlier->owed.size()));
  return true;
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
  const auto resumption = earlier_part(options, data, key, *read, plan);
  const auto face = examine_face(*read, plan, options.display != "headless" && !simulated);
  // A new file is made only when the devices are there; an old one is opened before anything shows.
  auto store = std::filesystem::exists(data) ? open_sqlite_store(data) : nullptr;
  if (!store) require_place_for(data);
  const auto devices = open_session_devices(protocol,
                                            {.display = options.display,
                                             .audio = options.audio,
                                             .simulated_answers = simulated,
                                             .windowed = options.windowed,
                                             .calibration = options.calibration});
  settle_visual_line(*devices, protocol, read->corpora);
  if (!may_go_on(*devices, options.strict, !simulated)) return ExitCode::Findings;
  const auto level = level_on(*devices->audio, read->protocol.sound);
  tell(level.text);
  if (!store) store = open_sqlite_store(data);
  StoreWriter writer{*store};
  tell_what_is_left_out(options);

  Repertoire repertoire{protocol.sound.rate, read->corpora};
  const auto drawing_rate = drawing_rate_for(devices->display->refresh().period);
  const auto quality = face ? quality_of(*face, protocol, drawing_rate) : ChosenQuality{};
  if (face) tell(describe(quality));
  auto record = session_record(*read, options.participant, key);
  record.simulated_answers = simulated;
  record.observer = simulated ? observer_name() : "";
  record.display = record_of(*devices->display);
  record.audio = record_of(*devices->audio);
  record.timing = devices->timing;
  record.keyboard_description = devices->keyboard->description();
  record.sound_levels = level.record;
  const bool drops_repetitions = goes_on(resumption, record, protocol);
  WatchedSession watched{data, record, protocol, plan, resumption, devices->clock};
  const auto done = resumption ? resumption->done : std::set<std::size_t>{};
  PreparationQueue queue{rest_of(plan, done), [&] {
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
    record.started_utc = utc_now();
    record.refresh_period = refresh.period;
    record.refresh_deviation = refresh.deviation;
    record.refresh_count = refresh.count;
    if (face) record.face = record_of(*face, quality);
    watched.begin(record);
    return begin_in(*store,
                    {.record = record,
                     .plan = plan_records(*read, plan),
                     .resumption = resumption,
                     .is_shortened = options.trials || options.no_practice,
                     .left_out = left_out,
                     .drops_repetitions = drops_repetitions,
                     .at = devices->clock.now()});
  };
  stop_at_interrupt();
  std::optional<std::int64_t> session;
  const auto booth = booth_of(*devices);
  const SessionParts parts{
      .protocol = protocol,
      .plan = plan,
      .booth = booth,
      .trials = queue,
      .store = writer,
      .begin = [&](const RefreshEstimate& refresh) { return *(session = begin(refresh)); },
      .plan_record =
          [&](const protocols::PlannedTrial& trial) {
            return plan_records(*read, {trial}).front();
          },
      .done = done,
      .first_repetition = resumption ? resumption->next_trial : 0,
      .answer = simulated ? simulated_answers(*read, key, protocol.seed) : Answers{},
      .interrupted = interrupt_asked,
      .announce = tell,
      .overseer = &watched};
  try {
    const auto outcome = run_session(parts);
    if (session) store->end(*session, outcome.complete ? "complete" : "stopped", utc_now());
    report_outcome(outcome,
                   {.planned = plan.size(),
                    .data = data.string(),
                    .predicted = devices->display->time_source() == TimeSource::Predicted},
                   resumption);
  } catch (const SoundLost& loss) {
    if (!session) throw;
    outlast_lost_sound(loss, booth, writer, *session, tell);
    store->end(*session, "stopped", utc_now());
  }
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
      "  bimodal run words414 --participant P01 --resume   # after a stop, a crash, a power cut\n"
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
  verb->add_flag("--resume",
                 options->resume,
                 "goes on with the session that was stopped or cut off: what is stored is not "
                 "presented again");
  verb->add_flag("--strict", options->strict, "refuses a screen that is not for timing");
  verb->add_option("--calibration",
                   options->calibration,
                   "times sound and picture by what instruments found (see `bimodal timing`)")
      ->check(name_that_is_not_empty());
  verb->add_flag("--again", options->again, "although this participant has this session already");
  verb->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace bimodal::runner
