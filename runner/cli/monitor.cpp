#include <array>
#include <cstdio>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include "runner/cli/terminal.hpp"
#include "runner/cli/verbs.hpp"
#include "runner/cli/watched_session.hpp"
#include "runner/devices/local/line_client.hpp"
#include "runner/devices/local/socket_places.hpp"
#include "runner/devices/monotonic_clock.hpp"
#include "runner/monitor/monitor_screen.hpp"
#include "runner/monitor/request_line.hpp"
#include "runner/store/stored_session.hpp"

namespace bimodal::runner {

namespace {

using namespace std::chrono_literals;

/// A session that runs answers at once; it listens for requests at every refresh, but not within a
/// stimulus.
constexpr auto kPatience = 5s;
constexpr auto kTick = 1s;
constexpr int kTickMs = 1'000;
constexpr const char* kKeys = "p pause/resume   s stop   q leave (the session goes on)";

struct MonitorOptions {
  std::string data;
  bool once = false;
  bool json = false;
  bool pause = false;
  bool resume = false;
  bool stop = false;
};

std::optional<LineClient> find_session(const std::string& data) {
  for (const auto& place : socket_places(data, kMonitorSocket)) {
    if (auto client = LineClient::connect(place)) return client;
  }
  return std::nullopt;
}

ExitCode show_stored(const MonitorOptions& options) {
  const auto sessions = read_sessions(options.data);
  fmt::print(stderr, "no session that stores in '{}' is running\n", options.data);
  if (options.json) return ExitCode::Findings;
  for (const auto& row : stored_screen(sessions)) fmt::print("{}\n", row);
  return ExitCode::Findings;
}

void print_rows(const SessionPicture& picture, ScreenSize size) {
  for (auto row : monitor_screen(picture, MonotonicClock{}.now(), size, "")) {
    row.erase(row.find_last_not_of(' ') + 1);
    fmt::print("{}\n", row);
  }
}

/// Takes what every new client is told; whether the session has told it all.
bool learn(LineClient& client, SessionPicture& picture, bool print_lines) {
  while (const auto line = client.next_line(kPatience)) {
    if (picture.take(*line) == "up_to_date") return true;
    if (print_lines) fmt::print("{}\n", *line);
  }
  return false;
}

ExitCode show_once(LineClient& client, bool json) {
  SessionPicture picture;
  if (!learn(client, picture, json)) {
    fmt::print(stderr, "bimodal: the session does not answer\n");
    return ExitCode::Findings;
  }
  if (!json) print_rows(picture, {.columns = 80, .rows = 60});
  return ExitCode::Done;
}

ExitCode tell_end(const SessionPicture& picture) {
  fmt::print("{}\n", end_text(picture));
  const auto outcome = picture.text("ended", "outcome");
  return outcome == "complete" || outcome == "stopped" ? ExitCode::Done : ExitCode::Findings;
}

/// Where there is no terminal to be repainted: a line for everything that happens, until the end.
ExitCode follow_lines(LineClient& client, bool json) {
  SessionPicture picture;
  while (!client.has_ended() && std::ferror(stdout) == 0) {
    const auto line = client.next_line(kTick);
    if (!line) continue;
    const auto kind = picture.take(*line);
    const auto shown = json ? *line : news_line(picture, kind);
    if (shown.empty() || kind == "up_to_date") continue;
    fmt::print("{}\n", shown);
    std::fflush(stdout);
  }
  if (!json) return tell_end(picture);
  return picture.knows("ended") ? ExitCode::Done : ExitCode::Findings;
}

/// The live screen. Leaving it leaves the session alone.
class LiveScreen {
 public:
  explicit LiveScreen(LineClient& client) : client_{client} {}

  /// True: the session has ended. False: the user leaves.
  bool run() {
    bool worth_painting = true;
    while (!client_.has_ended()) {
      if (worth_painting) paint();
      if (!take_keys() || Terminal::leave_asked() || terminal_gone_) return false;
      worth_painting = await_news();
    }
    return true;
  }

  [[nodiscard]] const SessionPicture& picture() const { return picture_; }

 private:
  void paint() {
    const std::string footer =
        asks_to_stop_ ? "Stop the session? y: stop; what is answered is kept.  n: go on." : kKeys;
    terminal_.paint(monitor_screen(picture_, clock_.now(), terminal_.size(), footer));
  }

  /// While a stimulus is on, the clock does not tick: nothing is drawn on a screen that may be the
  /// participant's neighbour.
  bool await_news() {
    std::array<pollfd, 2> polled{pollfd{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0},
                                 pollfd{.fd = client_.number(), .events = POLLIN, .revents = 0}};
    const bool news = ::poll(polled.data(), polled.size(), kTickMs) > 0;
    terminal_gone_ = (polled[0].revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
    while (const auto line = client_.next_line(0ms)) picture_.take(*line);
    return news || picture_.text("trial", "state") != "presenting";
  }

  /// False: leave.
  bool take_keys() {
    const auto key = terminal_.key();
    if (!key) return true;
    constexpr char kControlC = '\3';
    if (*key == kControlC) return false;
    if (asks_to_stop_) {
      if (*key == 'y') ask(Request::Stop);
      asks_to_stop_ = false;
    } else if (*key == 'q') {
      return false;
    } else if (*key == 's') {
      asks_to_stop_ = true;
    } else if (*key == 'p') {
      const auto state = picture_.text("pause", "state");
      ask(state == "paused" || state == "asked" ? Request::Resume : Request::Pause);
    }
    paint();
    return true;
  }

  void ask(Request request) { static_cast<void>(client_.send(request_line(request))); }

  LineClient& client_;
  Terminal terminal_;
  MonotonicClock clock_;
  SessionPicture picture_;
  bool asks_to_stop_ = false;
  bool terminal_gone_ = false;
};

ExitCode follow_screen(LineClient& client) {
  auto live = std::make_unique<LiveScreen>(client);
  const bool ended = live->run();
  const auto picture = live->picture();
  live.reset();  // the terminal is as before
  if (!ended) return ExitCode::Done;
  print_rows(picture, {.columns = 80, .rows = 60});
  return tell_end(picture);
}

/// Whether what was asked for has come about.
bool is_done(const SessionPicture& picture, Request request) {
  const auto state = picture.text("pause", "state");
  if (request == Request::Pause) return state == "paused";
  if (request == Request::Resume) return state == "running" || state.empty();
  return picture.knows("ended");
}

/// For scripts: asks, and returns when it has come about.
ExitCode ask_session(LineClient& client, Request request) {
  SessionPicture picture;
  if (!learn(client, picture, false) || !client.send(request_line(request))) {
    fmt::print(stderr, "bimodal: the session does not answer\n");
    return ExitCode::Findings;
  }
  bool taken = false;
  while (!client.has_ended() && !(taken && is_done(picture, request))) {
    const auto line = client.next_line(kTick);
    if (!line) continue;
    const auto kind = picture.take(*line);
    taken = taken || kind == "taken";
    if (kind == "pause" && picture.text("pause", "state") == "asked") {
      fmt::print("the pause begins when the present trial has been answered\n");
      std::fflush(stdout);
    }
  }
  if (client.has_ended() || picture.knows("ended")) {
    const auto code = tell_end(picture);
    return request == Request::Stop ? code : ExitCode::Findings;
  }
  fmt::print("{}\n", request == Request::Pause ? "paused" : "running");
  return ExitCode::Done;
}

ExitCode monitor(const MonitorOptions& options) {
  constexpr int kYielding = 10;  // the session comes first
  static_cast<void>(::setpriority(PRIO_PROCESS, 0, kYielding));
  auto client = find_session(options.data);
  if (!client) return show_stored(options);
  if (options.pause) return ask_session(*client, Request::Pause);
  if (options.resume) return ask_session(*client, Request::Resume);
  if (options.stop) return ask_session(*client, Request::Stop);
  if (options.once) return show_once(*client, options.json);
  if (options.json || !Terminal::is_there()) return follow_lines(*client, options.json);
  return follow_screen(*client);
}

}  // namespace

void add_monitor(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "monitor",
      "Shows a running session to the experimenter, in a terminal of its own: participant, block,\n"
      "trial, answers, flags, refresh and sound, time left. Keys: p pauses and resumes, s stops\n"
      "(asks first), q leaves; the session goes on without it. Nothing is asked of the session\n"
      "within a stimulus: a pause begins when the present trial has been answered; stop ends the\n"
      "session at once, but after a stimulus, and leaves out a trial that is not answered. Pause,\n"
      "then stop, to keep it. If no session is running, shows what the file holds (exit code 1).\n"
      "Only the user who runs the session can watch it.\n\n"
      "Examples:\n"
      "  bimodal monitor words414.sqlite\n"
      "  bimodal monitor words414.sqlite --once            one look; exit code 1: nothing runs\n"
      "  bimodal monitor words414.sqlite --json            all that is told, as lines of JSON\n"
      "  bimodal monitor words414.sqlite --pause           for scripts: returns when it is paused");
  auto options = std::make_shared<MonitorOptions>();
  verb->add_option("data", options->data, "the data file of the session: PROTOCOL.sqlite")
      ->required();
  verb->add_flag("--once", options->once, "one look, then ends");
  verb->add_flag("--json", options->json, "lines of JSON, one object a line");
  auto* const requests = verb->add_option_group("Requests", "one of");
  requests->add_flag("--pause", options->pause, "pauses the session, and waits for it");
  requests->add_flag("--resume", options->resume, "goes on");
  requests->add_flag("--stop", options->stop, "ends the session in order, and waits for it");
  requests->require_option(0, 1);
  verb->callback([options, &chosen] { chosen = [options] { return monitor(*options); }; });
}

}  // namespace bimodal::runner
