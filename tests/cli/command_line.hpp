#pragma once

// What the tests of the programs share: a folder with the small protocol "two.json", and how a
// program is run in it.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/exit_code.hpp"
#include "tests/cli/command.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal {

inline constexpr const char* kProtocol = R"({
  "bimodal_protocol": 1,
  "title": "Two words",
  "seed": 1,
  "instructions": ["Listen."],
  "words": ["cat", "fish"],
  "conditions": [
    {"name": "voice", "auditory": {"talker": "festival:kal"}, "snr_db": -4}
  ],
  "sound": {"speech_level_dbfs": -30}
}
)";

inline std::string replaced(std::string text, std::string_view what, std::string_view by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

/// Ended with `code`, having written what matches `output`.
inline testing::Matcher<Ended> ended(ExitCode code, const testing::Matcher<std::string>& output) {
  return testing::AllOf(testing::Field("output", &Ended::output, output),
                        testing::Field("exit_code", &Ended::exit_code, static_cast<int>(code)));
}

class CommandLine : public testing::Test {
 protected:
  CommandLine() { files_.write("two.json", kProtocol); }

  [[nodiscard]] Ended bimodal(const std::vector<std::string>& arguments,
                              const std::vector<std::string>& environment = {}) const {
    return run_command(files_.folder(), "bimodal", arguments, environment);
  }

  [[nodiscard]] Ended check(std::string_view protocol) const {
    files_.write("tried.json", protocol);
    return bimodal({"check", "tried.json"});
  }

  /// A session without window, sound and person; `more` comes last.
  [[nodiscard]] static std::vector<std::string> unattended(const std::vector<std::string>& more) {
    return unattended_run("two.json", more);
  }

  [[nodiscard]] std::string path(std::string_view name) const {
    return (files_.folder() / name).string();
  }

  [[nodiscard]] std::string bytes(std::string_view name) const {
    std::ifstream in{files_.folder() / name, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
  }

  WrittenFiles files_;
};

}  // namespace bimodal
