// Protocols whose answers are chosen, from their check to their report.

#include <set>

#include "runner/store/stored_session.hpp"
#include "tests/cli/command_line.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

using Choice = CommandLine;

constexpr const char* kChoice = R"({
  "bimodal_protocol": 1, "title": "Choice", "seed": 3,
  "words": [{ "word": "ba", "phones": ["B", "AA"] }, { "word": "wa", "phones": ["W", "AA"] }],
  "conditions": [{ "name": "noise", "auditory": { "talker": "festival:kal" }, "snr_db": -12 },
                 { "name": "clear", "auditory": { "talker": "festival:kal" } }],
  "assignment": "every-condition",
  "response": { "kind": "choice", "prompt": "ba or wa?", "confirm": true, "pointer": true,
                "options": [{ "label": "ba", "button": 2 }, { "label": "wa", "button": 1 }],
                "rt_from": "sound_onset" },
  "timing": { "flagged": "repeat" }
})";

TEST_F(Choice, RunsFromItsCheckToItsReport) {
  files_.write("choice.json", kChoice);
  EXPECT_THAT(bimodal({"check", "choice.json"}), ended(ExitCode::Done, HasSubstr("no mistakes")));
  EXPECT_THAT(bimodal({"rehearse", "choice.json", "--participants", "4", "--data", "c.sqlite"}),
              ended(ExitCode::Done, HasSubstr("16 trials")));
  std::set<std::string> responses;
  for (const auto& session : runner::read_sessions(path("c.sqlite"))) {
    for (const auto& trial : session.trials) {
      responses.insert(trial.trial.response.text);
      EXPECT_EQ(trial.trial.response.reference, "sound_onset");
      EXPECT_EQ(trial.trial.response.uncertainty, std::chrono::nanoseconds{0});
      EXPECT_FALSE(trial.trial.response.timed_out);
      if (trial.plan.condition == "clear") {
        EXPECT_EQ(trial.trial.response.text, trial.plan.word);
      }
    }
  }
  EXPECT_EQ(responses, (std::set<std::string>{"ba", "wa"}));
  EXPECT_THAT(
      run_command(files_.folder(), "bimodal-analysis", {"report", "c.sqlite", "-o", "report"}),
      ended(ExitCode::Done, HasSubstr("report")));
}

TEST_F(Choice, IsRunUnattendedToo) {
  files_.write("choice.json", kChoice);
  EXPECT_THAT(bimodal(unattended_run("choice.json", {"--participant", "P01", "--trials", "1"})),
              ended(ExitCode::Done, HasSubstr("complete: 1 of 1 trials")));
}

TEST_F(Choice, IsRefusedWithAllMistakesAtOnce) {
  const auto doubled = replaced(kChoice, R"("label": "wa")", R"("label": "ba")");
  EXPECT_THAT(check(replaced(doubled, "sound_onset", "visual_onset")),
              ended(ExitCode::InvalidInput,
                    AllOf(HasSubstr("/response/options/1/label: option 1 has the same label"),
                          HasSubstr("/response/rt_from: the condition \"noise\" has no picture"))));
}

}  // namespace
}  // namespace bimodal
