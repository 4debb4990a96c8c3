#include "runner/cli/instruments.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr Hertz kRate{48'000};

std::size_t frame_at(Duration at) {
  return static_cast<std::size_t>(nearest_sample(at, kRate).count());
}

/// Two seconds from a photodiode (left) and a cable (right), at the rate of the session clock.
class RecordedInput final : public AudioInput {
 public:
  RecordedInput(Duration light, Duration sound) : recorded_(2 * frame_at(2s)) {
    for (auto frame = frame_at(light); frame < frame_at(light + 50ms); ++frame) {
      recorded_[2 * frame] = 0.5F;
    }
    for (auto frame = frame_at(sound); frame < frame_at(sound + 50ms); ++frame) {
      recorded_[2 * frame + 1] = 0.5F * std::sin(0.13F * static_cast<float>(frame) + 1.0F);
    }
  }

  void start() override {}

  void collect(std::vector<float>& samples) override {
    samples.insert(samples.end(), recorded_.begin(), recorded_.end());
    recorded_.clear();
  }

  void stop() override {}

  [[nodiscard]] std::int64_t lost() const override { return 0; }

  [[nodiscard]] std::size_t channels() const override { return 2; }

  [[nodiscard]] std::optional<DeviceClock> clock() override {
    return DeviceClock{
        ClockFit{.sample = 0, .instant = Instant{}, .nanoseconds_per_sample = 1e9 / kRate.count()},
        jump ? 1 : 0,
        jump};
  }

  [[nodiscard]] Hertz rate() const override { return kRate; }

  [[nodiscard]] std::string kind() const override { return "recorded"; }

  [[nodiscard]] std::string description() const override { return "recorded"; }

  std::optional<std::int64_t> jump;

 private:
  std::vector<float> recorded_;
};

TimedTrial found_by(RecordedInput& input, Duration delay = {}) {
  Instruments instruments{input, {.delay = delay}};
  TimedTrial trial{.visual = 1s, .auditory = 1s};
  instruments.find(trial, [] {});
  return trial;
}

double off_ms(const std::optional<Duration>& found, Duration expected) {
  return found ? std::abs(std::chrono::duration<double, std::milli>{*found - expected}.count())
               : 1e9;
}

TEST(Instruments, FindWhenLightAndSoundCame) {
  RecordedInput input{1003ms, 1001ms};
  const auto trial = found_by(input);
  EXPECT_LT(off_ms(trial.true_visual, 1003ms), 0.05);
  EXPECT_LT(off_ms(trial.true_auditory, 1001ms), 0.05);
}

TEST(Instruments, AllowForWhatTheirCablesDelay) {
  RecordedInput input{1053ms, 1051ms};
  const auto trial = found_by(input, 50ms);
  EXPECT_LT(off_ms(trial.true_visual, 1003ms), 0.05);
  EXPECT_LT(off_ms(trial.true_auditory, 1001ms), 0.05);
}

TEST(Instruments, FindNothingWhereNothingCame) {
  RecordedInput input{1003ms, 1900ms};
  EXPECT_FALSE(found_by(input).true_auditory);
}

TEST(Instruments, DoNotMeasureAcrossAJumpOfTheInput) {
  RecordedInput between{1003ms, 1001ms};
  between.jump = static_cast<std::int64_t>(frame_at(1002ms));
  const auto trial = found_by(between);
  EXPECT_FALSE(trial.true_visual);
  EXPECT_FALSE(trial.true_auditory);
  RecordedInput before{1003ms, 1001ms};
  before.jump = static_cast<std::int64_t>(frame_at(500ms));
  EXPECT_TRUE(found_by(before).true_visual);
}

}  // namespace
}  // namespace bimodal::runner
