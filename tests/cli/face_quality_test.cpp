// In which quality a session's face is drawn, and what is said and stored about it.

#include <string>

#include "runner/store/stored_session.hpp"
#include "tests/cli/command_line.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class QualityOfTheFace : public CommandLine {
 protected:
  /// A protocol that shows the face, with these keys of the window.
  void write_protocol(const std::string& window) const {
    files_.write(
        "seen.json",
        replaced(
            replaced(kProtocol,
                     R"("name": "voice", "auditory": {"talker": "festival:kal"}, "snr_db": -4)",
                     R"("name": "face", "visual": {"talker": "face"})"),
            R"("seed": 1,)",
            R"("seed": 1, "window": {"face_height": 96)" + window + "},"));
  }

  /// The record of a session of one trial that nobody saw.
  [[nodiscard]] std::optional<runner::FaceDrawingRecord> recorded(
      const std::string& protocol, const testing::Matcher<std::string>& output) const {
    const auto run = bimodal(unattended_run(protocol,
                                            {"--participant",
                                             "P01",
                                             "--data",
                                             "x.sqlite",
                                             "--trials",
                                             "1",
                                             "--no-practice",
                                             "--again"}));
    EXPECT_THAT(run, ended(ExitCode::Done, output));
    const auto sessions = runner::read_sessions(path("x.sqlite"));
    return sessions.empty() ? std::nullopt : sessions.back().session.face;
  }
};

TEST_F(QualityOfTheFace, IsFastWhereNobodyLooksAndTheDataSaySo) {
  write_protocol("");
  const auto face = recorded("seen.json", HasSubstr("fast quality: nobody looks at it"));
  ASSERT_TRUE(face);
  EXPECT_EQ(face->quality, "fast");
  EXPECT_EQ(face->basis, "unwatched");
  EXPECT_EQ(face->full_picture, std::nullopt);
  EXPECT_THAT(face->renderer, HasSubstr("OpenGL"));
}

TEST_F(QualityOfTheFace, IsThatOfTheProtocolWhereverItRuns) {
  for (const std::string quality : {"fast", "full"}) {
    write_protocol(R"(, "face_quality": ")" + quality + '"');
    const auto face = recorded("seen.json", HasSubstr(quality + " quality, as the protocol says"));
    ASSERT_TRUE(face);
    EXPECT_EQ(face->quality, quality);
    EXPECT_EQ(face->basis, "protocol");
  }
}

TEST_F(QualityOfTheFace, IsNotStoredWhereNoFaceIsDrawn) {
  EXPECT_FALSE(recorded("two.json", Not(HasSubstr("quality"))));
  write_protocol("");
  ASSERT_EQ(bimodal({"rehearse", "seen.json", "--data", "r.sqlite"}).exit_code, 0);
  EXPECT_FALSE(runner::read_sessions(path("r.sqlite")).at(0).session.face);
}

TEST_F(QualityOfTheFace, IsToldByCheckWithWhatFullCosts) {
  const auto checked = [this] { return bimodal({"check", "seen.json"}).output; };
  write_protocol("");
  EXPECT_THAT(checked(), HasSubstr("if that keeps ahead of the session, else in fast"));
  write_protocol(R"(, "face_quality": "fast")");
  EXPECT_THAT(checked(), HasSubstr("fast quality, as the protocol says"));
  write_protocol(R"(, "face_quality": "full")");
  EXPECT_THAT(checked(),
              AllOf(HasSubstr("full quality, as the protocol says: a picture takes"),
                    HasSubstr("between stimuli")));
}

}  // namespace
}  // namespace bimodal
