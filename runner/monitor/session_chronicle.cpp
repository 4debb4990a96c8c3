#include "runner/monitor/session_chronicle.hpp"

#include <utility>

#include <nlohmann/json.hpp>

#include "runner/session/match.hpp"

namespace bimodal::runner {

namespace {

using Json = nlohmann::ordered_json;

/// Lines of another form have another number here.
constexpr int kVersion = 1;

std::int64_t nanoseconds(Instant at) {
  return at.time_since_epoch().count();
}

/// Absent is null.
template <typename T>
Json optional_json(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json optional_json(const std::optional<Duration>& value) {
  return value ? Json(value->count()) : Json(nullptr);
}

StatusLine line(const char* kind, Instant at, const Json& more) {
  Json object{{"kind", kind}, {"at_ns", nanoseconds(at)}};
  object.update(more);
  return {kind, object.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

const char* name(TrialState state) {
  switch (state) {
    case TrialState::Preparing:
      return "preparing";
    case TrialState::Fixation:
      return "fixation";
    case TrialState::Presenting:
      return "presenting";
    case TrialState::Responding:
      return "responding";
    case TrialState::Stored:
      return "stored";
  }
  return "";
}

const char* name(PauseChanged::State state) {
  switch (state) {
    case PauseChanged::State::Running:
      return "running";
    case PauseChanged::State::Asked:
      return "asked";
    case PauseChanged::State::Paused:
      return "paused";
  }
  return "";
}

const char* phase_of(const protocols::PlannedTrial& trial) {
  return trial.phase == protocols::Phase::Practice ? "practice" : "main";
}

/// Dubbed and ambiguous words have no one target to be spelled.
std::optional<bool> judged(const Word& word, const std::string& response) {
  if (word.seen || !word.articulation.empty()) return std::nullopt;
  return is_spelled_as(word.spelling, response);
}

StatusLine health_line(const Health& health) {
  return line("health",
              health.at,
              {{"refresh_period_ns", health.refresh_period.count()},
               {"refresh_deviation_ns", health.refresh_deviation.count()},
               {"refreshes_measured", health.refreshes_measured},
               {"missed_refreshes", health.missed_refreshes},
               {"late_frames", health.late_frames},
               {"underflows", health.underflows},
               {"sound_drift_ppm", optional_json(health.sound_drift_ppm)},
               {"sound_lost", health.sound_lost},
               {"longest_storing_ns", health.longest_storing.count()}});
}

}  // namespace

SessionChronicle::SessionChronicle(SessionDescription description)
    : description_{std::move(description)},
      tally_{description_.conditions},
      of_{description_.trials} {}

StatusLine SessionChronicle::description_line(Instant at) const {
  return line("session",
              at,
              {{"bimodal_monitor", kVersion},
               {"participant", description_.participant},
               {"session_number", description_.session_number},
               {"title", description_.title},
               {"data", description_.data},
               {"started_utc", description_.started_utc},
               {"trials", description_.trials},
               {"blocks", description_.blocks},
               {"conditions", description_.conditions},
               {"display", description_.display},
               {"audio", description_.audio},
               {"verdict", optional_json(description_.verdict)},
               {"simulated_answers", description_.simulated_answers},
               {"stored_before", description_.stored_before}});
}

std::vector<StatusLine> SessionChronicle::on(const Progress& progress) {
  return std::visit(Match{[this](const PageShown& page) {
                            if (!began_) began_ = page.at;
                            return on_page(page);
                          },
                          [this](const TrialReached& reached) {
                            if (!began_) began_ = reached.at;
                            return on_trial(reached);
                          },
                          [this](const TrialResult& result) { return on_result(result); },
                          [](const Health& health) { return Lines{health_line(health)}; },
                          [this](const PauseChanged& pause) { return on_pause(pause); },
                          [this](const SessionEnded& ended) { return Lines{end_line(ended)}; }},
                    progress);
}

SessionChronicle::Lines SessionChronicle::on_page(const PageShown& page) const {
  return {line("page", page.at, {{"text", page.text}, {"is_break", page.is_break}}),
          times_line(page.at)};
}

SessionChronicle::Lines SessionChronicle::on_trial(const TrialReached& reached) {
  const auto& trial = reached.trial;
  of_ = reached.of;
  if (reached.state == TrialState::Preparing) {
    trial_began_ = reached.at;
    paused_in_trial_ = {};
  }
  if (reached.state == TrialState::Stored && trial_began_) {
    remaining_.add(reached.at - *trial_began_ - paused_in_trial_);
    trial_began_.reset();
  }
  return {line("trial",
               reached.at,
               {{"trial", trial.index},
                {"of", reached.of},
                {"block", trial.block},
                {"phase", phase_of(trial)},
                {"condition", condition_of(trial)},
                {"word", shown_name(trial.word)},
                {"state", name(reached.state)}})};
}

SessionChronicle::Lines SessionChronicle::on_result(const TrialResult& result) {
  const auto& trial = result.trial;
  const auto spelled = judged(trial.word, result.response);
  auto events = Json::array();
  for (const auto& [kind, detail] : result.events) {
    events.push_back({{"kind", kind}, {"detail", detail}});
  }
  tally_.add({.trial = trial.index,
              .is_practice = trial.phase == protocols::Phase::Practice,
              .condition = condition_of(trial),
              .word = shown_name(trial.word),
              .response = result.response,
              .spelled_as_target = spelled,
              .flagged = result.flagged});
  return {line("result",
               result.at,
               {{"trial", trial.index},
                {"response", result.response},
                {"spelled_as_target", optional_json(spelled)},
                {"timed_out", result.timed_out},
                {"flagged", result.flagged},
                {"events", events}}),
          tally_line(result.at),
          times_line(result.at)};
}

SessionChronicle::Lines SessionChronicle::on_pause(const PauseChanged& pause) {
  if (pause.state == PauseChanged::State::Paused && !paused_since_) paused_since_ = pause.at;
  if (pause.state == PauseChanged::State::Running && paused_since_) {
    paused_in_trial_ += pause.at - *paused_since_;
    paused_since_.reset();
  }
  return {line("pause", pause.at, {{"state", name(pause.state)}, {"reason", pause.reason}})};
}

StatusLine SessionChronicle::tally_line(Instant at) const {
  auto conditions = Json::array();
  for (const auto& tally : tally_.conditions()) {
    conditions.push_back({{"condition", tally.condition},
                          {"trials", tally.trials},
                          {"judged", tally.judged},
                          {"spelled_as_target", tally.spelled_as_target}});
  }
  auto latest = Json::array();
  for (const auto& trial : tally_.latest()) {
    latest.push_back({{"trial", trial.trial},
                      {"condition", trial.condition},
                      {"word", trial.word},
                      {"response", trial.response},
                      {"spelled_as_target", optional_json(trial.spelled_as_target)},
                      {"flagged", trial.flagged}});
  }
  return line("tally",
              at,
              {{"stored", stored()},
               {"flagged", flagged()},
               {"conditions", conditions},
               {"latest", latest}});
}

StatusLine SessionChronicle::times_line(Instant at) const {
  const auto to_come = of_ - std::min(of_, stored());
  return line("times",
              at,
              {{"elapsed_ns", began_ ? (at - *began_).count() : 0},
               {"typical_trial_ns", optional_json(remaining_.typical_trial())},
               {"trials_to_come", to_come},
               {"left_ns", optional_json(remaining_.left(to_come))}});
}

StatusLine SessionChronicle::end_line(const SessionEnded& ended) const {
  return line("ended",
              ended.at,
              {{"outcome", ended.outcome},
               {"detail", ended.detail},
               {"stored", stored()},
               {"of", of_},
               {"flagged", flagged()}});
}

const std::string& SessionChronicle::condition_of(const protocols::PlannedTrial& trial) const {
  return description_.conditions.at(trial.condition);
}

}  // namespace bimodal::runner
