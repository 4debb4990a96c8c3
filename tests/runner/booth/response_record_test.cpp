#include "runner/booth/response_record.hpp"

#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using protocols::RtFrom;

/// Seen at 1.0 s, as reported; heard at 1.1 s, as planned, for nothing was reported.
TrialRecord trial() {
  TrialRecord made{.stimulus_end = 2s};
  made.onsets = {{.modality = "visual", .planned = 990ms, .reported = 1s},
                 {.modality = "auditory", .planned = 1'100ms, .reported = std::nullopt}};
  return made;
}

const RecordResponse kAnswer{
    .text = "ba", .submitted = Instant{2'500ms}, .first_key = Instant{2'400ms}, .uncertainty = 3ms};

TEST(ResponseRecord, CountsFromTheReportedOnsetElseFromThePlannedOne) {
  EXPECT_EQ(response_record(kAnswer, RtFrom::VisualOnset, trial()).reference_at, 1s);
  EXPECT_EQ(response_record(kAnswer, RtFrom::SoundOnset, trial()).reference_at, 1'100ms);
  EXPECT_EQ(response_record(kAnswer, RtFrom::End, trial()).reference_at, 2s);
}

TEST(ResponseRecord, SaysThatItCountsFromTheEndWhereATrialHasNoSuchOnset) {
  auto silent = trial();
  silent.onsets.pop_back();
  const auto record = response_record(kAnswer, RtFrom::SoundOnset, silent);
  EXPECT_EQ(record.reference, "end");
  EXPECT_EQ(record.reference_at, 2s);
}

TEST(ResponseRecord, KeepsTheStampsAndTheirUncertainty) {
  const auto record = response_record(kAnswer, RtFrom::End, trial());
  EXPECT_EQ(record.text, "ba");
  EXPECT_EQ(record.submitted, 2'500ms);
  EXPECT_EQ(record.first_key, 2'400ms);
  EXPECT_EQ(record.uncertainty, 3ms);
  EXPECT_FALSE(record.timed_out);
}

TEST(ResponseRecord, KnowsNoUncertaintyWhereTheTimeRanOut) {
  const auto record =
      response_record({.submitted = Instant{3s}, .timed_out = true}, RtFrom::End, trial());
  EXPECT_EQ(record.uncertainty, std::nullopt);
  EXPECT_TRUE(record.timed_out);
}

}  // namespace
}  // namespace bimodal::runner
