#include "runner/devices/portaudio/portaudio_input.hpp"

#include <csignal>
#include <cstdlib>
#include <memory>
#include <string>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "runner/devices/device_error.hpp"
#include "runner/devices/monotonic_clock.hpp"
#include "runner/devices/portaudio/portaudio_session.hpp"

namespace bimodal::runner {
namespace {

using ::testing::HasSubstr;

std::string message_of(const PortaudioInputOptions& options) {
  try {
    const PortaudioInput input{options};
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PortaudioInput, SaysWhatToDoOnAMachineWithoutMicrophone) {
  if (!describe_microphones().empty()) GTEST_SKIP() << "this machine has a microphone";
  EXPECT_EQ(message_of({}),
            "cannot open a microphone: this machine has none; connect one, start a sound server, "
            "or try without one by --input simulated:FILE, a recording of the words");
}

TEST(PortaudioInput, RefusesADeviceThatIsNotThere) {
  EXPECT_THAT(message_of({.device = "no such device"}), HasSubstr("cannot open"));
}

/// A sound server of its own without a card: it delivers silence at the pace of a card.
class SoundServer {
 public:
  SoundServer() : name_{"bimodal-test-" + std::to_string(::getpid())} {
    ::setenv("JACK_DEFAULT_SERVER", name_.c_str(), 1);
    ::setenv("JACK_NO_START_SERVER", "1", 1);
    std::string arguments[] = {
        "jackd", "--no-realtime", "-n", name_, "-d", "dummy", "-r", "48000", "-p", "256"};
    std::vector<char*> pointers;
    for (auto& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO}) {
      posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
    }
    runs_ = posix_spawnp(&server_, "jackd", &actions, nullptr, pointers.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
  }

  SoundServer(const SoundServer&) = delete;
  SoundServer& operator=(const SoundServer&) = delete;
  SoundServer(SoundServer&&) = delete;
  SoundServer& operator=(SoundServer&&) = delete;

  ~SoundServer() {
    end();
    ::unsetenv("JACK_DEFAULT_SERVER");
    ::unsetenv("JACK_NO_START_SERVER");
  }

  void end() {
    if (!runs_) return;
    runs_ = false;
    ::kill(server_, SIGTERM);
    ::waitpid(server_, nullptr, 0);
  }

  /// A microphone of this server; null if it does not come up within ten seconds.
  [[nodiscard]] std::unique_ptr<PortaudioInput> microphone() const {
    const MonotonicClock clock;
    const auto deadline = clock.now() + std::chrono::seconds{10};
    while (runs_ && clock.now() < deadline) {
      try {
        return std::make_unique<PortaudioInput>(PortaudioInputOptions{.device = "JACK"});
      } catch (const DeviceError&) {
        continue;  // the server is still starting
      }
    }
    return nullptr;
  }

 private:
  std::string name_;
  pid_t server_ = 0;
  bool runs_ = false;
};

TEST(PortaudioInput, CapturesFromASoundServerUntilThatIsGone) {
  if (std::system("command -v jackd > /dev/null") != 0) GTEST_SKIP() << "jackd is not installed";
  SoundServer server;
  const auto input = server.microphone();
  if (!input) GTEST_SKIP() << "jackd does not start here";
  EXPECT_THAT(input->description(), HasSubstr("JACK"));
  EXPECT_EQ(input->rate(), Hertz{48'000});
  std::vector<float> samples;
  input->collect(samples);
  EXPECT_TRUE(samples.empty()) << "nothing is captured before start()";
  for (int capture = 0; capture < 2; ++capture) {
    samples.clear();
    input->start();
    while (samples.size() < 9'600) input->collect(samples);
    input->stop();
    for (const float sample : samples) ASSERT_EQ(sample, 0.0F);
    EXPECT_GE(input->lost(), 0);
  }
  input->start();
  server.end();
  EXPECT_THROW(
      while (true) {
        samples.clear();
        input->collect(samples);
      },
      DeviceError);
}

}  // namespace
}  // namespace bimodal::runner
