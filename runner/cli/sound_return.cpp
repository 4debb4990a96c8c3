#include "runner/cli/sound_return.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "runner/booth/participant_screens.hpp"
#include "runner/cli/interrupt.hpp"

namespace bimodal::runner {

namespace {

using namespace std::chrono_literals;

constexpr const char* kItself = "/proc/self/exe";

std::vector<std::string> own_arguments() {
  std::ifstream in{"/proc/self/cmdline", std::ios::binary};
  const std::string all{std::istreambuf_iterator<char>{in}, {}};
  std::vector<std::string> arguments;
  for (std::size_t at = 0; at < all.size();) {
    arguments.emplace_back(all.c_str() + at);
    at += arguments.back().size() + 1;
  }
  return arguments;
}

std::vector<char*> as_argv(std::vector<std::string>& arguments) {
  std::vector<char*> argv;
  for (auto& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  return argv;
}

/// Looks whether there is a sound output, in a process of its own that may hang or die.
class Look {
 public:
  Look() {
    std::vector<std::string> arguments{"bimodal", "devices", "--has-sound"};
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    if (::posix_spawn(&process_, kItself, &actions, nullptr, as_argv(arguments).data(), environ) !=
        0) {
      process_ = -1;
    }
    posix_spawn_file_actions_destroy(&actions);
  }

  Look(const Look&) = delete;
  Look& operator=(const Look&) = delete;
  Look(Look&&) = delete;
  Look& operator=(Look&&) = delete;

  ~Look() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }

  /// Absent: it is still looking.
  std::optional<bool> found() {
    if (process_ <= 0) return false;
    int status = 0;
    const auto ended = ::waitpid(process_, &status, WNOHANG);
    if (ended == 0) return std::nullopt;
    process_ = -1;
    return ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

 private:
  pid_t process_ = -1;
};

}  // namespace

bool await_sound(const Booth& booth, const std::function<bool()>& stopped) {
  constexpr Duration kBetween = 2s;
  const auto page = pause_screen();
  auto next = booth.clock.now() + kBetween;
  std::optional<Look> look;
  while (!stopped()) {
    static_cast<void>(booth.display.present(page, booth.clock.now()));
    if (std::ranges::any_of(booth.keyboard.poll(), asks_to_stop)) return false;
    if (!look && booth.clock.now() >= next) look.emplace();
    if (!look) continue;
    const auto found = look->found();
    if (!found && booth.clock.now() < next + 5 * kBetween) continue;
    if (found.value_or(false)) return true;
    look.reset();
    next = booth.clock.now() + kBetween;
  }
  return false;
}

std::string begin_anew_and_resume() {
  auto arguments = own_arguments();
  if (std::ranges::find(arguments, "--resume") == arguments.end())
    arguments.emplace_back("--resume");
  std::erase(arguments, "--again");
  ::execv(kItself, as_argv(arguments).data());
  return std::strerror(errno);
}

void outlast_lost_sound(const SoundLost& loss,
                        const Booth& booth,
                        StoreWriter& writer,
                        std::int64_t session,
                        const std::function<void(std::string_view)>& tell) {
  tell(
      fmt::format("paused: {}\nthe session goes on by itself when the sound is back; Escape or "
                  "Ctrl-C stops",
                  loss.what()));
  const EventRecord paused{.at = booth.clock.now().time_since_epoch(),
                           .kind = "paused",
                           .detail = "the sound device was lost"};
  writer.add(session, paused).get();
  if (await_sound(booth, interrupt_asked)) {
    tell("the sound is back: the session goes on where it was");
    throw DeviceError{"cannot begin anew: " + begin_anew_and_resume()};
  }
  tell("stopped; what was answered is kept, and --resume goes on");
}

}  // namespace bimodal::runner
