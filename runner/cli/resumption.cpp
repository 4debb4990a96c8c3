#include "runner/cli/resumption.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "runner/cli/session_setup.hpp"
#include "runner/cli/watched_session.hpp"
#include "runner/devices/local/local_socket.hpp"
#include "runner/devices/local/socket_places.hpp"
#include "runner/store/stored_session.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

bool is_same(const PlanRecord& one, const PlanRecord& other) {
  return one.trial == other.trial && one.phase == other.phase && one.block == other.block &&
         one.word == other.word && one.condition == other.condition &&
         one.noise_seed == other.noise_seed;
}

bool is_running(const std::filesystem::path& data) {
  const auto places = socket_places(data, kMonitorSocket);
  return std::ranges::any_of(places,
                             [](const auto& place) { return connect_to(place).has_value(); });
}

Resumption resumption_of(const StoredSession& stored, std::size_t next_trial) {
  Resumption resumption{.session = stored.session.id,
                        .done = {},
                        .next_trial = next_trial,
                        .timing = stored.session.timing,
                        .sound_levels = stored.session.sound_levels};
  std::set<std::size_t> excluded;
  for (const auto& [plan, trial] : stored.trials) {
    const auto original = static_cast<std::size_t>(plan.repeats.value_or(plan.trial));
    if (!plan.repeats) resumption.done.insert(original);
    resumption.flagged += trial.flagged ? 1 : 0;
    if (trial.excluded && plan.phase == "main") excluded.insert(original);
    if (!trial.excluded) excluded.erase(original);
  }
  resumption.owed.assign(excluded.begin(), excluded.end());
  return resumption;
}

[[noreturn]] void refuse(const std::filesystem::path& data,
                         const std::string& participant,
                         int session,
                         std::string_view why) {
  throw Error{fmt::format("cannot resume session {} of participant '{}' in '{}': {}",
                          session,
                          participant,
                          data.string(),
                          why)};
}

}  // namespace

Resumption find_resumption(const std::filesystem::path& data,
                           const std::string& participant,
                           protocols::SessionKey key,
                           const protocols::ReadProtocol& read,
                           const std::vector<protocols::PlannedTrial>& plan) {
  if (!std::filesystem::exists(data)) {
    refuse(data, participant, key.session_number, "there is no such file; name it by --data");
  }
  if (is_running(data)) {
    refuse(data,
           participant,
           key.session_number,
           "a session that stores there is running (`bimodal monitor` shows it); end it first");
  }
  auto sessions = read_sessions(data);
  std::ranges::reverse(sessions);
  bool has_other_protocol = false;
  for (const auto& stored : sessions) {
    const auto& session = stored.session;
    if (session.participant != participant || session.session_number != key.session_number)
      continue;
    if (session.protocol_sha256 != read.sha256) {
      has_other_protocol = true;
      continue;
    }
    if (stored.outcome == "complete") {
      refuse(data, participant, key.session_number, "it is complete");
    }
    const auto planned = read_plan(data, session.id);
    const auto now = plan_records(read, plan);
    if (!std::ranges::equal(planned, now, is_same)) {
      refuse(data,
             participant,
             key.session_number,
             "it was planned otherwise; give the same --trials, --no-practice, --with, --without "
             "and --corpus as then");
    }
    return resumption_of(stored, next_trial(data, session.id));
  }
  refuse(data,
         participant,
         key.session_number,
         has_other_protocol
             ? "it was run with another protocol, or the protocol has been changed since"
             : "there is none; leave --resume out");
}

void require_same_terms(const Resumption& resumption, const SessionRecord& record) {
  if (!resumption.timing || !record.timing) return;
  if (resumption.timing->calibration != record.timing->calibration) {
    throw Error{fmt::format(
        "cannot resume: the session began {}; give the same --calibration, as it was then",
        resumption.timing->calibration.empty()
            ? std::string{"without a calibration"}
            : "with the calibration " + resumption.timing->calibration)};
  }
  if (resumption.sound_levels != record.sound_levels) {
    throw Error{
        "cannot resume: the session began at other sound levels: with another output, or the "
        "measurements (`bimodal levels list`) have been changed since; go on as it began, or begin "
        "anew by --again"};
  }
}

std::vector<protocols::PlannedTrial> rest_of(const std::vector<protocols::PlannedTrial>& plan,
                                             const std::set<std::size_t>& done) {
  std::vector<protocols::PlannedTrial> rest;
  std::ranges::copy_if(plan, std::back_inserter(rest), [&](const protocols::PlannedTrial& trial) {
    return !done.contains(trial.index);
  });
  return rest;
}

}  // namespace bimodal::runner
