#include "runner/calibration/level_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/calibration/speech_level.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::runner {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

MeasuredLevel measured(double dbspl, std::optional<int> channel = std::nullopt) {
  return {.device = "card", .channel = channel, .dbfs = Decibels{-30}, .dbspl = DecibelsSpl{dbspl}};
}

SpeechCalibration calibrated(const LevelTable& table, const Listening& listening) {
  const auto found = calibration_for(table, listening);
  const auto* const missing = std::get_if<NotCalibrated>(&found);
  EXPECT_EQ(missing, nullptr) << missing->finding;
  return missing == nullptr ? std::get<SpeechCalibration>(found) : SpeechCalibration{};
}

std::string missing_in(const LevelTable& table, const Listening& listening) {
  const auto found = calibration_for(table, listening);
  const auto* const missing = std::get_if<NotCalibrated>(&found);
  return missing == nullptr ? "nothing" : missing->finding;
}

TEST(SpeechCalibration, GoesDecibelByDecibel) {
  const auto calibration = calibrated(LevelTable{{measured(65.2)}}, {.device = "card"});
  EXPECT_NEAR(calibration.spl_at(Decibels{-30}).count(), 65.2, 1e-9);
  EXPECT_NEAR(calibration.spl_at(Decibels{-20}).count(), 75.2, 1e-9);
  EXPECT_NEAR(calibration.level_for(DecibelsSpl{60}).count(), -35.2, 1e-9);
  Random random{1};
  for (int i = 0; i < 100; ++i) {
    const DecibelsSpl wanted{100 * random.uniform()};
    EXPECT_NEAR(calibration.spl_at(calibration.level_for(wanted)).count(), wanted.count(), 1e-9);
  }
}

TEST(SpeechCalibration, HoldsForTheVeryDeviceRateAndBandOnly) {
  const LevelTable table{{measured(65.2)}};
  EXPECT_THAT(missing_in(table, {.device = "other"}), HasSubstr("channel 1 of 'other' at 48000"));
  EXPECT_THAT(missing_in(table, {.device = "card", .rate_hz = 44'100}), HasSubstr("44100"));
  EXPECT_THAT(missing_in(table, {.device = "card", .low_hz = 100}),
              AllOf(HasSubstr("noise of 100-8000 Hz"),
                    HasSubstr("has not been measured (but noise of 80-8000 Hz has)")));
}

TEST(SpeechCalibration, OfAToneIsNotOneOfSpeech) {
  auto tone = measured(65.2);
  tone.low_hz = tone.high_hz = 1'000;
  EXPECT_THAT(missing_in(LevelTable{{tone}}, {.device = "card"}),
              HasSubstr("(but a tone of 1000 Hz has)"));
}

TEST(SpeechCalibration, TakesEachChannelByItselfWhereItWasMeasuredSo) {
  const LevelTable table{{measured(65), measured(64, 1), measured(66.5, 2)}};
  const auto both = calibrated(table, {.device = "card"});
  EXPECT_EQ(both.spl_at(Decibels{-30}).count(), 64);
  EXPECT_EQ(both.spread.count(), 2.5);
  const auto right = calibrated(table, {.device = "card", .channels = {2}});
  EXPECT_EQ(right.spl_at(Decibels{-30}).count(), 66.5);
  EXPECT_EQ(right.spread.count(), 0.0);
}

TEST(SpeechCalibration, OfBothEarsIsNotOneOfAnotherChannel) {
  const LevelTable table{{measured(65)}};
  EXPECT_EQ(calibrated(table, {.device = "card", .channels = {2}}).measured.size(), 1U);
  EXPECT_THAT(missing_in(table, {.device = "card", .channels = {3}}), HasSubstr("on channel 3"));
}

TEST(LevelTable, ReplacesWhatWasMeasuredAtTheSamePlace) {
  LevelTable table;
  EXPECT_FALSE(table.put(measured(65)));
  EXPECT_FALSE(table.put(measured(64, 1)));
  const auto earlier = table.put(measured(66));
  ASSERT_TRUE(earlier.has_value());
  EXPECT_EQ(earlier->dbspl, DecibelsSpl{65});
  ASSERT_EQ(table.levels().size(), 2U);
  EXPECT_EQ(table.levels()[0].dbspl, DecibelsSpl{66});
}

TEST(LevelTable, IsReadAsItWasWritten) {
  auto tone = measured(71.5, 4);
  tone.low_hz = tone.high_hz = 1'000;
  tone.device = "Scarlett \"4i4\" (ALSA)";
  tone.date = "2026-01-31";
  tone.instrument = "B&K 2250";
  tone.note = "HD 650, knob at 12 o'clock";
  const WrittenFiles files;
  const auto file = files.folder() / "new" / "folder" / "levels.json";
  write_levels(file, LevelTable{{measured(65.25), tone}});
  const auto table = read_levels(file);
  ASSERT_EQ(table.levels().size(), 2U);
  EXPECT_TRUE(same_place(table.levels()[0], measured(0)));
  EXPECT_EQ(table.levels()[0].dbspl, DecibelsSpl{65.25});
  EXPECT_TRUE(same_place(table.levels()[1], tone));
  EXPECT_EQ(table.levels()[1].instrument, tone.instrument);
  EXPECT_EQ(table.levels()[1].note, tone.note);
  EXPECT_EQ(table.text(), (LevelTable{{measured(65.25), tone}}.text()));
}

TEST(LevelTable, IsEmptyWhereThereIsNoFile) {
  EXPECT_TRUE(read_levels("/nowhere/levels.json").levels().empty());
}

TEST(LevelTable, TellsOfEveryMistakeWithItsLine) {
  std::vector<Diagnostic> diagnostics;
  EXPECT_FALSE(read_levels_text(R"({
    "bimodal_levels": 1,
    "levels": [
      {"device": "card", "rate_hz": 48000, "band_hz": [8000, 80], "dbfs": -30, "dbspl": 65},
      {"device": "card", "rate_hz": "fast", "frequency_hz": 1000, "dbfs": 3, "dbspl": 65,
       "chanel": 1}
    ]})",
                                "levels.json",
                                diagnostics));
  std::vector<std::string> messages;
  for (const auto& diagnostic : diagnostics) messages.push_back(describe(diagnostic));
  EXPECT_THAT(
      messages,
      ElementsAre(HasSubstr("levels.json:4: /levels/0/band_hz: the lower edge"),
                  HasSubstr("levels.json:5: /levels/1/rate_hz: \"fast\" is not a whole number"),
                  HasSubstr("/levels/1/dbfs: 3 is"),
                  HasSubstr("did you mean \"channel\"?")));
}

TEST(LevelTable, RefusesAFileThatCannotBeUsed) {
  const WrittenFiles files;
  const auto file = files.write("levels.json", "{ levels }");
  try {
    static_cast<void>(read_levels(file));
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("levels.json:1"), HasSubstr("not JSON")));
  }
}

}  // namespace
}  // namespace bimodal::runner
