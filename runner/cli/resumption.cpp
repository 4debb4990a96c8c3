#include "runner/cli/resumption.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "runner/cli/session_setup.hpp"
#include "runner/store/stored_session.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

bool is_same(const PlanRecord& one, const PlanRecord& other) {
  return one.trial == other.trial && one.phase == other.phase && one.block == other.block &&
         one.word == other.word && one.condition == other.condition &&
         one.noise_seed == other.noise_seed;
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
    Resumption resumption{
        .session = session.id, .done = {}, .next_trial = next_trial(data, session.id)};
    for (const auto& trial : stored.trials) {
      if (!trial.plan.repeats) resumption.done.insert(static_cast<std::size_t>(trial.plan.trial));
    }
    return resumption;
  }
  refuse(data,
         participant,
         key.session_number,
         has_other_protocol
             ? "it was run with another protocol, or the protocol has been changed since"
             : "there is none; leave --resume out");
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
