#include "runner/devices/local/line_server.hpp"

#include <functional>
#include <random>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include "runner/devices/device_error.hpp"
#include "runner/devices/local/line_client.hpp"
#include "runner/devices/local/local_socket.hpp"
#include "tests/runner/realtime/count_allocations.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Optional;

constexpr auto kPatience = 10s;

/// Whether it becomes true in time.
bool eventually(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::yield();
  }
  return true;
}

class LineServerTest : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path socket() const { return files_ / "x.monitor"; }

  /// Connected, and known to the server.
  LineClient connect(const LineServer& server) {
    const auto before = server.clients();
    auto client = LineClient::connect(socket());
    EXPECT_TRUE(client.has_value());
    EXPECT_TRUE(eventually([&] { return server.clients() == before + 1; }));
    return std::move(*client);
  }

  static std::string next(LineClient& client) {
    return client.next_line(kPatience).value_or("(nothing)");
  }

  static std::string awaited(LineServer& server) {
    std::optional<ReceivedLine> line;
    EXPECT_TRUE(eventually([&] {
      line = server.next_line();
      return line.has_value();
    }));
    return line ? line->text : "(nothing)";
  }

  std::string refusal() {
    try {
      const LineServer server{socket()};
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "";
  }

  WrittenFiles files_;
};

TEST_F(LineServerTest, TellsEveryClientEveryLine) {
  LineServer server{socket()};
  auto one = connect(server);
  auto two = connect(server);
  EXPECT_TRUE(server.publish("trial", "first"));
  EXPECT_TRUE(server.publish("trial", "second"));
  for (auto* client : {&one, &two}) {
    EXPECT_EQ(next(*client), "first");
    EXPECT_EQ(next(*client), "second");
  }
}

TEST_F(LineServerTest, TellsWhoeverComesLaterTheNewestLineOfEachKindFirst) {
  LineServer server{socket()};
  ASSERT_TRUE(server.publish("session", "P01"));
  ASSERT_TRUE(server.publish("trial", "1"));
  ASSERT_TRUE(server.publish("", "of the moment"));
  ASSERT_TRUE(server.publish("trial", "2"));
  auto client = connect(server);
  ASSERT_TRUE(server.publish("trial", "3"));
  EXPECT_EQ(next(client), "P01");
  EXPECT_EQ(next(client), "2");
  EXPECT_EQ(next(client), "3");
}

TEST_F(LineServerTest, TellsWhoeverComesWhenItHasBeenToldEverything) {
  LineServer server{socket(), {.welcome = "that is all"}};
  ASSERT_TRUE(server.publish("trial", "1"));
  auto client = connect(server);
  ASSERT_TRUE(server.publish("trial", "2"));
  EXPECT_EQ(next(client), "1");
  EXPECT_EQ(next(client), "that is all");
  EXPECT_EQ(next(client), "2");
}

TEST_F(LineServerTest, GivesWhatClientsSendAndAnswersTheSenderOnly) {
  LineServer server{socket()};
  auto one = connect(server);
  auto two = connect(server);
  ASSERT_TRUE(two.send("pause\r"));
  std::optional<ReceivedLine> line;
  ASSERT_TRUE(eventually([&] {
    line = server.next_line();
    return line.has_value();
  }));
  EXPECT_EQ(line->text, "pause");
  ASSERT_TRUE(server.answer(line->client, "taken"));
  ASSERT_TRUE(server.publish("", "to all"));
  EXPECT_EQ(next(two), "taken");
  EXPECT_EQ(next(two), "to all");
  EXPECT_EQ(next(one), "to all");
}

TEST_F(LineServerTest, TakesTheLastWordsOfAClientThatLeaves) {
  LineServer server{socket()};
  {
    auto client = connect(server);
    ASSERT_TRUE(client.send("stop"));
  }
  EXPECT_EQ(awaited(server), "stop");
  EXPECT_TRUE(eventually([&] { return server.clients() == 0; }));
}

TEST_F(LineServerTest, DropsAClientThatDoesNotReadAndGoesOnWithTheOthers) {
  LineServer server{socket(), {.most_unread = 16UL << 10U}};
  auto idle = connect(server);
  auto reader = connect(server);
  const std::string line(1'000, 'x');
  int told = 0;
  ASSERT_TRUE(eventually([&] {
    EXPECT_TRUE(server.publish("", line));
    EXPECT_EQ(next(reader), line);
    ++told;
    return server.clients() == 1;
  }));
  EXPECT_GT(told, 16);
  ASSERT_TRUE(server.publish("", "still there"));
  EXPECT_EQ(next(reader), "still there");
}

TEST_F(LineServerTest, RefusesWhatItHasNoRoomForInsteadOfWaiting) {
  LineServer server{socket(), {.hand_over = 1024}};
  EXPECT_FALSE(server.publish("", std::string(2'000, 'x')));
  EXPECT_FALSE(server.publish("", "two\nlines"));
  EXPECT_TRUE(server.publish("", "one"));
}

TEST_F(LineServerTest, PublishesWithoutAllocating) {
  LineServer server{socket()};
  const auto client = connect(server);
  const std::string line(500, 'x');
  EXPECT_TRUE(server.publish("trial", line));
  const auto before = allocations_of_this_thread();
  for (int i = 0; i < 100; ++i) static_cast<void>(server.publish("trial", line));
  EXPECT_EQ(allocations_of_this_thread(), before);
}

TEST_F(LineServerTest, AnswersOverlongLinesAndWhatIsNoTextWithAnErrorAndGoesOn) {
  LineServer server{socket(), {.longest_line = 100}};
  auto client = connect(server);
  ASSERT_TRUE(client.send(std::string(5'000, 'x')));
  EXPECT_THAT(next(client), AllOf(HasSubstr(R"("kind":"error")"), HasSubstr("at most 100 bytes")));
  ASSERT_TRUE(client.send("\xff\xfe"));
  EXPECT_THAT(next(client), HasSubstr("UTF-8"));
  ASSERT_TRUE(client.send("fine"));
  EXPECT_EQ(awaited(server), "fine");
  EXPECT_EQ(server.next_line(), std::nullopt);
}

TEST_F(LineServerTest, KeepsNoMoreThanItHasRoomForUntilTheSessionListens) {
  LineServer server{socket()};
  auto client = connect(server);
  const std::string line(4'000, 'x');
  std::optional<std::string> complaint;
  ASSERT_TRUE(eventually([&] {
    static_cast<void>(client.send(line));
    complaint = client.next_line(0ms);
    return complaint.has_value();
  }));
  EXPECT_THAT(complaint, Optional(HasSubstr("too many lines")));
}

TEST_F(LineServerTest, SurvivesWhateverClientsSend) {
  LineServer server{socket(), {.longest_line = 64}};
  std::mt19937 random{1};
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    auto client = LineClient::connect(socket());
    ASSERT_TRUE(client.has_value());
    std::string bytes = Damage{seed}(R"({"ask":"pause"}{"ask":"stop"})");
    for (auto& byte : bytes) {
      if (random() % 20 == 0) byte = static_cast<char>(random());
    }
    static_cast<void>(client->send(bytes));
    while (const auto line = server.next_line()) {
      EXPECT_LE(line->text.size(), 64U);
      EXPECT_EQ(line->text.find('\n'), std::string::npos);
    }
  }
  auto last = LineClient::connect(socket());
  ASSERT_TRUE(last.has_value() && last->send("still there"));
  EXPECT_TRUE(eventually([&] {
    const auto line = server.next_line();
    return line && line->text == "still there";
  }));
}

TEST_F(LineServerTest, TellsWhoeverIsOneTooManyWhy) {
  LineServer server{socket(), {.most_clients = 1}};
  const auto first = connect(server);
  auto second = LineClient::connect(socket());
  ASSERT_TRUE(second.has_value());
  EXPECT_THAT(next(*second), HasSubstr("too many programs"));
  EXPECT_EQ(second->next_line(kPatience), std::nullopt);
  EXPECT_TRUE(second->has_ended());
}

TEST_F(LineServerTest, DeliversItsLastLineBeforeItEnds) {
  auto server = std::make_unique<LineServer>(socket());
  auto client = connect(*server);
  ASSERT_TRUE(server->publish("ended", "complete"));
  server.reset();
  EXPECT_EQ(next(client), "complete");
  EXPECT_EQ(client.next_line(kPatience), std::nullopt);
  EXPECT_TRUE(client.has_ended());
  EXPECT_FALSE(client.send("anybody?"));
  EXPECT_FALSE(std::filesystem::exists(socket()));
}

TEST_F(LineServerTest, HasASocketForItsOwnerOnly) {
  const auto old_mask = umask(0);
  const LineServer server{socket()};
  umask(old_mask);
  EXPECT_EQ(std::filesystem::status(socket()).permissions(), std::filesystem::perms{0600});
}

TEST_F(LineServerTest, ReplacesTheSocketOfAProcessThatHasDied) {
  const auto died = fork();
  if (died == 0) {
    const int left = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    socket().string().copy(address.sun_path, sizeof address.sun_path - 1);
    const bool bound = bind(left, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    _exit(bound && listen(left, 1) == 0 ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(died, &status, 0), died);
  ASSERT_EQ(status, 0);
  ASSERT_TRUE(std::filesystem::is_socket(socket()));
  LineServer server{socket()};
  auto client = connect(server);
  ASSERT_TRUE(server.publish("", "alive"));
  EXPECT_EQ(next(client), "alive");
}

TEST_F(LineServerTest, LeavesTheSocketOfALivingProcessAlone) {
  LineServer server{socket()};
  EXPECT_THAT(refusal(), AllOf(HasSubstr(socket().string()), HasSubstr("another program")));
  ASSERT_TRUE(server.publish("state", "alive"));
  auto client = LineClient::connect(socket());
  ASSERT_TRUE(client.has_value());
  EXPECT_EQ(next(*client), "alive");
}

TEST_F(LineServerTest, LeavesAFileThatIsNoSocketAlone) {
  files_.write("x.monitor", "my notes");
  EXPECT_THAT(refusal(), HasSubstr("move it away"));
  EXPECT_TRUE(std::filesystem::is_regular_file(socket()));
}

TEST_F(LineServerTest, TellsOfAPathThatIsTooLong) {
  const auto path = files_ / std::string(120, 'x');
  try {
    const LineServer server{path};
    FAIL() << "a socket cannot have such a path";
  } catch (const DeviceError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr(path.string()), HasSubstr("at most 107 bytes")));
  }
  EXPECT_FALSE(LineClient::connect(path).has_value());
}

TEST_F(LineServerTest, ListensToNoOtherUser) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can become somebody else";
  const LineServer server{socket()};
  std::filesystem::permissions(socket(), std::filesystem::perms{0666});
  const auto other = fork();
  if (other == 0) {
    constexpr uid_t kNobody = 65'534;
    if (setuid(kNobody) != 0) _exit(2);
    const int descriptor = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    socket().string().copy(address.sun_path, sizeof address.sun_path - 1);
    if (::connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
      _exit(3);
    }
    char byte = 0;
    _exit(recv(descriptor, &byte, 1, 0) <= 0 ? 0 : 1);  // sees the end, and nothing before it
  }
  int status = 0;
  ASSERT_EQ(waitpid(other, &status, 0), other);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(server.clients(), 0U);
}

}  // namespace
}  // namespace bimodal::runner
