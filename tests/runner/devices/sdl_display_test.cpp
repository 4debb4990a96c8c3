#include "runner/devices/sdl/sdl_display.hpp"

#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "runner/devices/device_error.hpp"

namespace bimodal::runner {
namespace {

/// Sets an environment variable for the length of one test.
class Environment {
 public:
  Environment(std::string name, const char* value) : name_{std::move(name)} {
    const auto* before = std::getenv(name_.c_str());
    if (before != nullptr) before_ = before;
    assign(value);
  }

  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
  Environment(Environment&&) = delete;
  Environment& operator=(Environment&&) = delete;

  ~Environment() { assign(before_ ? before_->c_str() : nullptr); }

 private:
  void assign(const char* value) {
    if (value != nullptr) {
      setenv(name_.c_str(), value, 1);
    } else {
      unsetenv(name_.c_str());
    }
  }

  std::string name_;
  std::optional<std::string> before_;
};

std::string message_of_opening() {
  try {
    const SdlWindow window{{}};
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "opened";
}

TEST(SdlWindow, SaysWhatToDoWhereThereIsNoDisplay) {
  const Environment x11{"DISPLAY", ":4711"};
  const Environment wayland{"WAYLAND_DISPLAY", "no-such-display"};
  const Environment driver{"SDL_VIDEODRIVER", "wayland,x11"};
  const auto message = message_of_opening();
  EXPECT_NE(message.find("no display found"), std::string::npos) << message;
  EXPECT_NE(message.find("--display headless"), std::string::npos) << message;
  EXPECT_NE(message.find("WAYLAND_DISPLAY"), std::string::npos) << message;
}

TEST(SdlWindow, RefusesADriverThatShowsNothing) {
  const Environment driver{"SDL_VIDEODRIVER", "dummy"};
  const auto message = message_of_opening();
  EXPECT_NE(message.find("\"dummy\", which shows nothing"), std::string::npos) << message;
}

/// The rest needs a screen, be it Xvfb or a compositor without one.
class SdlDisplayOnScreen : public testing::Test {
 protected:
  void SetUp() override {
    try {
      window_.emplace(SdlWindow::Options{.width = 320, .height = 240});
    } catch (const DeviceError& error) {
      GTEST_SKIP() << error.what();
    }
    display_.emplace(*window_);
  }

  std::optional<SdlWindow> window_;
  std::optional<SdlDisplay> display_;
};

TEST_F(SdlDisplayOnScreen, PresentsEachScreenAfterTheOneBeforeAndSaysHowItKnows) {
  const std::vector<std::uint8_t> pixels(std::size_t{64} * 48 * 4, 200);
  const Picture picture{.width = 64, .height = 48, .pixels = pixels};
  Screen screen{.picture = &picture, .fixation = true, .captions = {{.text = "Ünïcode"}}};
  auto last = Instant{};
  for (int k = 0; k < 20; ++k) {
    screen.picture = k % 2 == 0 ? &picture : nullptr;
    const auto deadline = nearest_refresh(display_->refresh(), last + display_->refresh().period);
    const auto presentation = display_->present(screen, deadline);
    EXPECT_GT(presentation.onset, last);
    EXPECT_EQ(presentation.lateness, presentation.onset - deadline);
    EXPECT_LE(presentation.source, display_->time_source());
    last = presentation.onset;
  }
  EXPECT_GT(display_->refresh().period, Duration::zero());
  EXPECT_NE(display_->description().find("onsets"), std::string::npos);
  EXPECT_EQ(display_->kind(), "sdl");
}

TEST_F(SdlDisplayOnScreen, SaysWhyBetterReportsAreNotUsedOrThatTheyAre) {
  const auto description = display_->description();
  const auto* const best =
      SdlWindow::driver() == "wayland" ? "wp_presentation" : "GLX_OML_sync_control";
  if (SdlWindow::driver() == "KMSDRM") GTEST_SKIP() << "a console has none";
  EXPECT_NE(description.find(best), std::string::npos) << description;
  const bool is_refused = description.find("not by " + std::string{best}) != std::string::npos;
  EXPECT_NE(is_refused, display_->time_source() == TimeSource::DriverReported) << description;
}

TEST_F(SdlDisplayOnScreen, RefusesAPictureLargerThanTheWindow) {
  const std::vector<std::uint8_t> pixels(std::size_t{5000} * 16 * 4);
  const Picture picture{.width = 5000, .height = 16, .pixels = pixels};
  const Screen screen{.picture = &picture};
  EXPECT_THROW(display_->present(screen, Instant{}), DeviceError);
}

}  // namespace
}  // namespace bimodal::runner
