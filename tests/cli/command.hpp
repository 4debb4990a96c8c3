#pragma once

#include <array>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <string>
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

/// Runs a program of this build in `folder` and waits for its end. `environment` holds operands of
/// env(1): "NAME=value" sets a variable, "-u" "NAME" takes one away.
inline Ended run_command(const std::filesystem::path& folder,
                         const std::string& program,
                         const std::vector<std::string>& arguments,
                         const std::vector<std::string>& environment = {}) {
  std::vector<std::string> words{"env", "-C", folder.string()};
  words.insert(words.end(), environment.begin(), environment.end());
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
  pid_t child = 0;
  const int failure = posix_spawnp(&child, "env", &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  Ended ended;
  if (failure == 0) {
    std::array<char, 4096> part{};
    ssize_t count = 0;
    while ((count = read(ends[0], part.data(), part.size())) > 0) {
      ended.output.append(part.data(), static_cast<std::size_t>(count));
    }
    int status = 0;
    if (waitpid(child, &status, 0) == child && WIFEXITED(status)) {
      ended.exit_code = WEXITSTATUS(status);
    }
  }
  close(ends[0]);
  if (failure != 0) throw std::runtime_error{"cannot start env"};
  return ended;
}

inline void PrintTo(const Ended& run, std::ostream* out) {
  *out << "exit code " << run.exit_code << "\n" << run.output;
}

}  // namespace bimodal
