#include "stimuli/audio/take_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/random.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Hertz kRate{48'000};
constexpr Decibels kRoom{-60.0};

/// One second of the room, in which a tone of 500 Hz and amplitude `peak` sounds from `from` to
/// `to`.
Clip take(double peak, Duration from = 300ms, Duration to = 700ms, double room_db = -60.0) {
  Random random{3};
  Clip made{kRate, std::vector<float>(48'000)};
  const double room = std::pow(10.0, room_db / 20.0);
  const auto first = nearest_sample(from, kRate).count();
  const auto end = nearest_sample(to, kRate).count();
  for (std::int64_t i = 0; i < 48'000; ++i) {
    const double phase = 2.0 * std::numbers::pi * 500.0 * static_cast<double>(i) / kRate.count();
    const double tone = i >= first && i < end ? peak * std::sin(phase) : 0.0;
    const double sum = room * random.normal() + tone;
    made.samples[static_cast<std::size_t>(i)] = static_cast<float>(std::clamp(sum, -1.0, 1.0));
  }
  return made;
}

std::vector<TakeFault> judged(const Clip& sound, std::int64_t lost = 0) {
  return faults_of(measure_take(sound, kRoom), lost);
}

TEST(MeasureTake, AgreesWithWhatASineMustHave) {
  // A sine of amplitude 0.1 has an RMS of 20 log10(0.1 / sqrt 2) = -23.01 dB, and a peak of -20 dB,
  // to which the room, at three times its RMS, adds 0.26 dB. That the end of speech is found up to
  // a frame late, 410 ms for 400, takes 10 log10(410 / 400) = 0.11 dB from the level.
  const auto measures = measure_take(take(0.1), kRoom);
  EXPECT_NEAR(measures.level.count(), -23.01, 0.12);
  EXPECT_NEAR(measures.peak.count(), -20.0, 0.5);
  EXPECT_NEAR(measures.snr.count(), 60.0 - 23.01, 0.12);
  EXPECT_EQ(measures.clipped, 0U);
  EXPECT_EQ(measures.duration, 1s);
  ASSERT_TRUE(measures.speech);
  EXPECT_EQ(measures.speech->start, 300ms);
  EXPECT_GE(measures.speech->end, 700ms);
  EXPECT_LE(measures.speech->end, 710ms);
}

/// What sox says of "RMS lev dB" or "Pk lev dB".
double told_by_sox(const std::string& file, const std::string& trim, const std::string& what) {
  const auto command = "sox '" + file + "' -n trim " + trim + " stats 2>&1";
  const std::unique_ptr<FILE, decltype([](FILE* pipe) { pclose(pipe); })> pipe{
      popen(command.c_str(), "r")};
  std::string output;
  std::array<char, 256> part{};
  while (std::fgets(part.data(), static_cast<int>(part.size()), pipe.get()) != nullptr) {
    output += part.data();
  }
  const auto at = output.find(what);
  return at == std::string::npos ? std::nan("") : std::stod(output.substr(at + what.size()));
}

TEST(MeasureTake, AgreesWithSox) {
  if (std::system("command -v sox > /dev/null") != 0) GTEST_SKIP() << "sox is not installed";
  const WrittenFiles files;
  const auto file = (files.folder() / "take.wav").string();
  const auto sound = take(0.37);
  write_wav(file, sound);
  const auto measures = measure_take(sound, kRoom);
  ASSERT_TRUE(measures.speech);
  const auto seconds = [](Duration time) {
    return std::to_string(std::chrono::duration<double>{time}.count());
  };
  const auto speech = seconds(measures.speech->start) + " =" + seconds(measures.speech->end);
  EXPECT_NEAR(measures.level.count(), told_by_sox(file, speech, "RMS lev dB"), 0.01);
  EXPECT_NEAR(measures.peak.count(), told_by_sox(file, "0 1", "Pk lev dB"), 0.01);
}

TEST(MeasureTake, CountsSamplesAtFullScale) {
  // |sin| is at least 0.999 / 1.2 during 1 - 2 asin(0.8325) / pi of the time: 0.3737 of 19200.
  Clip sound{kRate, std::vector<float>(48'000)};
  for (std::size_t i = 14'400; i < 33'600; ++i) {
    const double phase = 2.0 * std::numbers::pi * 501.3 * static_cast<double>(i) / kRate.count();
    sound.samples[i] = static_cast<float>(std::clamp(1.2 * std::sin(phase), -1.0, 1.0));
  }
  const double expected = 19'200.0 * (1.0 - 2.0 * std::asin(0.999 / 1.2) / std::numbers::pi);
  EXPECT_NEAR(static_cast<double>(measure_take(sound, kRoom).clipped), expected, 40.0);
  // The largest sample of a 16-bit device.
  sound.samples.assign(48'000, 32'767.0F / 32'768.0F);
  EXPECT_EQ(measure_take(sound, kRoom).clipped, 48'000U);
}

TEST(FaultsOfATake, AreNoneForAGoodOne) {
  EXPECT_THAT(judged(take(0.1)), IsEmpty());
}

TEST(FaultsOfATake, TellsEachThatThereIs) {
  EXPECT_THAT(judged(take(0.0)), ElementsAre(TakeFault::Nothing));
  EXPECT_THAT(judged(take(0.1), 12), ElementsAre(TakeFault::Gaps));
  EXPECT_THAT(judged(take(1.2)), ElementsAre(TakeFault::Clipped));
  EXPECT_THAT(judged(take(0.02)), ElementsAre(TakeFault::Quiet));
  EXPECT_THAT(judged(take(0.1, 90ms, 500ms)), ElementsAre(TakeFault::BegunEarly));
  EXPECT_THAT(judged(take(0.1, 300ms, 910ms)), ElementsAre(TakeFault::CutOff));
  EXPECT_THAT(judged(take(0.1, 110ms, 890ms)), IsEmpty());
  const auto noisy = take(0.1, 300ms, 700ms, -40.0);
  EXPECT_THAT(faults_of(measure_take(noisy, Decibels{-40.0}), 0), ElementsAre(TakeFault::Noisy));
}

TEST(FaultsOfATake, ComeWithTheMostUrgentFirst) {
  EXPECT_THAT(judged(take(1.2, 50ms, 1s)),
              ElementsAre(TakeFault::Clipped, TakeFault::BegunEarly, TakeFault::CutOff));
}

TEST(FaultsOfATake, OfAnEmptyOneIsThatNothingWasHeard) {
  EXPECT_THAT(judged({kRate, {}}), ElementsAre(TakeFault::Nothing));
}

TEST(FaultsOfATake, AreStoredByNamesThatComeBack) {
  for (int fault = 0; fault <= static_cast<int>(TakeFault::CutOff); ++fault) {
    const auto meant = static_cast<TakeFault>(fault);
    EXPECT_EQ(take_fault(name(meant)), meant);
    EXPECT_FALSE(advice(meant).empty());
  }
  EXPECT_FALSE(take_fault("loud"));
}

}  // namespace
}  // namespace bimodal
