#include "runner/cli/watched_session.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include <fmt/format.h>

#include "runner/devices/device_error.hpp"
#include "runner/devices/local/local_socket.hpp"
#include "runner/devices/local/socket_places.hpp"
#include "runner/monitor/request_line.hpp"

namespace bimodal::runner {

namespace {

/// New clients know by it that they have been told how things stand.
constexpr const char* kUpToDate = R"({"kind":"up_to_date"})";

SessionDescription describe(const std::filesystem::path& data,
                            const SessionRecord& session,
                            const protocols::Protocol& protocol,
                            const std::vector<protocols::PlannedTrial>& plan,
                            const std::optional<Resumption>& earlier) {
  SessionDescription description{.participant = session.participant,
                                 .session_number = session.session_number,
                                 .title = session.protocol_title,
                                 .data = data.string(),
                                 .started_utc = session.started_utc,
                                 .trials = plan.size(),
                                 .display = session.display.description,
                                 .audio = session.audio.description,
                                 .simulated_answers = session.simulated_answers};
  for (const auto& condition : protocol.conditions) {
    description.conditions.push_back(condition.name);
  }
  for (const auto& trial : plan) {
    description.blocks = std::max(description.blocks, trial.block + 1);
  }
  if (earlier) {
    description.stored_before = earlier->done.size();
    description.flagged_before = static_cast<std::size_t>(earlier->flagged);
  }
  return description;
}

/// Null, and the reason on standard error, if the session cannot be watched.
std::unique_ptr<LineServer> open_server(const std::filesystem::path& data) {
  std::string reason = "there is no place for a socket";
  for (const auto& place : socket_places(data, kMonitorSocket)) {
    if (connect_to(place)) {
      reason = fmt::format("another session stores in '{}' and is watched", data.string());
      break;
    }
    try {
      return std::make_unique<LineServer>(place, LineServerOptions{.welcome = kUpToDate});
    } catch (const DeviceError& error) {
      reason = error.what();
    }
  }
  fmt::print(stderr, "bimodal: this session cannot be watched by `bimodal monitor`: {}\n", reason);
  return nullptr;
}

}  // namespace

WatchedSession::WatchedSession(const std::filesystem::path& data,
                               const SessionRecord& session,
                               const protocols::Protocol& protocol,
                               const std::vector<protocols::PlannedTrial>& plan,
                               const std::optional<Resumption>& earlier,
                               const Clock& clock)
    : clock_{clock},
      chronicle_{describe(data, session, protocol, plan, earlier)},
      server_{open_server(data)} {
  publish(chronicle_.description_line(clock_.now()));
}

void WatchedSession::begin(const SessionRecord& session) {
  if (session.timing) chronicle_.judge(session.timing->verdict);
  publish(chronicle_.description_line(clock_.now()));
}

void WatchedSession::tell(const Progress& progress) {
  for (const auto& line : chronicle_.on(progress)) publish(line);
}

std::optional<Request> WatchedSession::request() {
  const auto line = server_ ? server_->next_line() : std::nullopt;
  if (!line) return std::nullopt;
  const auto read = read_request(line->text);
  if (const auto* const fault = std::get_if<LineFault>(&read)) {
    server_->answer(line->client, error_line(*fault));
    return std::nullopt;
  }
  const auto request = std::get<Request>(read);
  server_->answer(line->client, taken_line(request));
  return request;
}

void WatchedSession::publish(const StatusLine& line) {
  if (server_) server_->publish(line.kind, line.text);
}

}  // namespace bimodal::runner
