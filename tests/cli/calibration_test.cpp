#include "runner/cli/calibration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/cli/resumption.hpp"
#include "stimuli/base/error.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::runner {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Calibration measured() {
  const Moments moments{.count = 100,
                        .mean_ms = 12.5,
                        .deviation_ms = 0.2,
                        .median_ms = 12.5,
                        .smallest_ms = 12.0,
                        .largest_ms = 13.0};
  return {.name = "booth",
          .made_utc = "2026-11-23T12:00:00Z",
          .display = "a screen",
          .audio = "a loudspeaker",
          .input = "a card",
          .offset = moments,
          .visual = moments,
          .auditory = moments};
}

class CalibrationFile : public testing::Test {
 protected:
  void expect_refused(const Calibration& calibration) {
    write_calibration(calibration, file_);
    EXPECT_THAT([&] { static_cast<void>(read_calibration(file_)); },
                ThrowsMessage<Error>(HasSubstr("numbers that no measurement gives")));
  }

  WrittenFiles files_;
  std::filesystem::path file_ = files_.folder() / "booth.json";
};

TEST_F(CalibrationFile, IsReadAsItWasWritten) {
  write_calibration(measured(), file_);
  EXPECT_EQ(as_text(read_calibration(file_)), as_text(measured()));
}

TEST_F(CalibrationFile, WithNumbersThatNoMeasurementGivesIsRefused) {
  for (const double mean : {1e300, 5000.0, -5000.0}) {
    auto far = measured();
    far.offset.mean_ms = far.offset.smallest_ms = far.offset.largest_ms = mean;
    expect_refused(far);
  }
  auto negative = measured();
  negative.visual.deviation_ms = -1.0;
  expect_refused(negative);
  auto disordered = measured();
  disordered.auditory.smallest_ms = 12.9;
  expect_refused(disordered);
  auto empty = measured();
  empty.offset.count = 0;
  expect_refused(empty);
}

TEST_F(CalibrationFile, ThatIsAFolderIsRefused) {
  EXPECT_THROW(static_cast<void>(read_calibration(files_.folder())), Error);
}

TEST(SameTerms, AreRequiredOfASessionThatGoesOn) {
  const TimingRecord with{.calibration = "{}"};
  SessionRecord record{.sound_levels = "loud"};
  record.timing = with;
  const Resumption same{.timing = with, .sound_levels = "loud"};
  EXPECT_NO_THROW(require_same_terms(same, record));
  const Resumption other_levels{.timing = with, .sound_levels = "soft"};
  EXPECT_THAT([&] { require_same_terms(other_levels, record); },
              ThrowsMessage<Error>(HasSubstr("other sound levels")));
  const Resumption uncalibrated{.timing = TimingRecord{}, .sound_levels = "loud"};
  EXPECT_THAT([&] { require_same_terms(uncalibrated, record); },
              ThrowsMessage<Error>(HasSubstr("began without a calibration")));
}

}  // namespace
}  // namespace bimodal::runner
