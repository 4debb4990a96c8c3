#pragma once

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bimodal {

/// What a program wrote (standard output and error, as they came) and how it ended.
struct Ended {
  std::string output;
  int exit_code = -1;  ///< -1: ended by a signal
};

/// A program of this build that runs in `folder`. `environment` holds operands of env(1):
/// "NAME=value" sets a variable, "-u" "NAME" takes one away.
class StartedCommand {
 public:
  StartedCommand(const std::filesystem::path& folder,
                 const std::string& program,
                 const std::vector<std::string>& arguments,
                 const std::vector<std::string>& environment = {}) {
    std::vector<std::string> words{"env", "-C", folder.string()};
    words.insert(words.end(), environment.begin(), environment.end());
    // Nothing is kept in the user's own cache, and nothing known from the user's measurements.
    for (const std::string_view ours : {"BIMODAL_CACHE=", "BIMODAL_LEVELS=levels.json"}) {
      const auto name = ours.substr(0, ours.find('=') + 1);
      const auto sets = [&](const std::string& word) { return word.starts_with(name); };
      if (std::ranges::none_of(environment, sets)) words.emplace_back(ours);
    }
    words.push_back(std::string{BIMODAL_BIN "/"} + program);
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (auto& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);

    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error{"pipe2 failed"};
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    const int failure = posix_spawnp(&child_, "env", &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    from_ = ends[0];
    if (failure != 0) {
      close(from_);
      throw std::runtime_error{"cannot start env"};
    }
  }

  StartedCommand(const StartedCommand&) = delete;
  StartedCommand& operator=(const StartedCommand&) = delete;
  StartedCommand(StartedCommand&&) = delete;
  StartedCommand& operator=(StartedCommand&&) = delete;

  ~StartedCommand() {
    if (child_ > 0) {
      kill(child_, SIGKILL);
      waitpid(child_, nullptr, 0);
    }
    close(from_);
  }

  /// Waits until the program has written `text`; false if it ends without.
  bool await(std::string_view text) {
    while (output_.find(text) == std::string::npos) {
      if (!read_on()) return false;
    }
    return true;
  }

  /// Ends it as a power cut would.
  void kill_at_once() const { kill(child_, SIGKILL); }

  /// Ends it as Ctrl-C would.
  void interrupt() const { kill(child_, SIGINT); }

  /// Waits until it ends.
  Ended end() {
    while (read_on()) {
    }
    Ended ended{.output = output_};
    int status = 0;
    if (waitpid(child_, &status, 0) == child_ && WIFEXITED(status)) {
      ended.exit_code = WEXITSTATUS(status);
    }
    child_ = 0;
    return ended;
  }

 private:
  bool read_on() {
    std::array<char, 4096> part{};
    const auto count = read(from_, part.data(), part.size());
    if (count <= 0) return false;
    output_.append(part.data(), static_cast<std::size_t>(count));
    return true;
  }

  pid_t child_ = 0;
  int from_ = -1;
  std::string output_;
};

/// Runs it and waits for its end.
inline Ended run_command(const std::filesystem::path& folder,
                         const std::string& program,
                         const std::vector<std::string>& arguments,
                         const std::vector<std::string>& environment = {}) {
  return StartedCommand{folder, program, arguments, environment}.end();
}

/// The arguments of a session without window and person; `more` comes last.
inline std::vector<std::string> unattended_run(const std::string& protocol,
                                               const std::vector<std::string>& more,
                                               const std::string& audio = "none") {
  std::vector<std::string> arguments{
      "run", protocol, "--display", "headless", "--audio", audio, "--answers", "simulated"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

inline void PrintTo(const Ended& run, std::ostream* out) {
  *out << "exit code " << run.exit_code << "\n" << run.output;
}

}  // namespace bimodal
