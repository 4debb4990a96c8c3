// The face at any pose, from the command line.

#include "stimuli/picture/image.hpp"
#include "tests/cli/command_line.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class FaceVerb : public CommandLine {
 protected:
  [[nodiscard]] Ended face(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "face");
    return bimodal(arguments);
  }

  /// A small picture "x.png" of these arguments, and what was said.
  [[nodiscard]] Ended drawn(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--height", "90", "-o", "x.png"});
    return face(std::move(arguments));
  }

  /// Whether the machine can draw at all.
  [[nodiscard]] bool has_opengl() const { return drawn({}).exit_code == 0; }
};

TEST_F(FaceVerb, ListsEveryControlWithItsRangeUnitAndMeaning) {
  EXPECT_THAT(face({"--list"}),
              ended(ExitCode::Done,
                    AllOf(HasSubstr("jaw rotation"),
                          HasSubstr("lip_width"),
                          HasSubstr("gaze_y"),
                          HasSubstr("opening of the lower jaw"))));
}

TEST_F(FaceVerb, MeasuresWhatItDraws) {
  EXPECT_THAT(
      face({"--controls", "jaw=3,lower_lip_tuck=1", "--measure"}),
      ended(ExitCode::Done, AllOf(HasSubstr("upper_teeth_mm2"), HasSubstr("lip_to_incisors_mm"))));
}

TEST_F(FaceVerb, KnowsItsExpressionsAndNamesThemToWhoAsksForAnother) {
  EXPECT_THAT(face({"--expression", "smile=0.5", "--measure"}),
              ended(ExitCode::Done, HasSubstr("corner_up_mm")));
  EXPECT_THAT(face({"--expression", "boredom", "--measure"}),
              ended(ExitCode::InvalidInput, HasSubstr("there are smile, surprise")));
  EXPECT_THAT(face({"--expression", "smile=2", "--measure"}),
              ended(ExitCode::InvalidInput, HasSubstr("from 0 to 1")));
  EXPECT_THAT(face({"--expression", "smile,smile=1", "--measure"}),
              ended(ExitCode::InvalidInput, HasSubstr("twice")));
}

TEST_F(FaceVerb, DrawsAPoseByTheFacesOrThePapersNames) {
  if (!has_opengl()) GTEST_SKIP() << "no OpenGL here";
  EXPECT_THAT(
      drawn({"--controls", "jaw=8,lip_width=-10"}),
      ended(ExitCode::Done, AllOf(HasSubstr("x.png: 80 x 90 pixels"), HasSubstr("degrees high"))));
  const auto picture = bytes("x.png");
  EXPECT_EQ(drawn({"--controls", "Jaw-Rotation=8,mouth width=-10"}).exit_code, 0);
  EXPECT_EQ(drawn({"--controls", "jaw=8,width=-10"}).exit_code, 0);
  EXPECT_EQ(bytes("x.png"), picture);
  EXPECT_EQ(drawn({"--controls", "jaw=7,lip_width=-10"}).exit_code, 0);
  EXPECT_NE(bytes("x.png"), picture);
}

TEST_F(FaceVerb, TakesTheEndOfARangeAndSaysSo) {
  if (!has_opengl()) GTEST_SKIP() << "no OpenGL here";
  EXPECT_THAT(
      drawn({"--controls", "jaw=40"}),
      ended(ExitCode::Done, HasSubstr("bimodal: jaw 40 is outside 0 to 22 deg; drawn at 22")));
  EXPECT_THAT(
      drawn({"--expression", "surprise=1,fear=1"}),
      ended(ExitCode::Done, HasSubstr("bimodal: brow_raise 12 is outside -4 to 9 mm; drawn at 9")));
}

TEST_F(FaceVerb, RefusesControlsThatCannotBeMeant) {
  EXPECT_THAT(drawn({"--controls", "jwa=8"}),
              ended(ExitCode::InvalidInput,
                    AllOf(HasSubstr("no control 'jwa'"), HasSubstr("did you mean jaw?"))));
  for (const auto* const setting : {"jaw=nan", "jaw=inf", "jaw=", "jaw=8mm", "jaw"}) {
    EXPECT_THAT(drawn({"--controls", setting}),
                ended(ExitCode::InvalidInput, AllOf(HasSubstr(setting), HasSubstr("jaw=8"))));
  }
  EXPECT_THAT(drawn({"--controls", "jaw=1,jaw_rotation=2"}),
              ended(ExitCode::InvalidInput, HasSubstr("jaw is set twice")));
  EXPECT_THAT(face({}), ended(ExitCode::InvalidInput, HasSubstr("-o FILE.png")));
}

TEST_F(FaceVerb, RefusesViewsAndLooksThatCannotBeMeant) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--yaw", "nan"},
                                                    {"--transparency", "1.5"},
                                                    {"--view", "top"},
                                                    {"--shading", "phong"},
                                                    {"--camera-distance", "20"},
                                                    {"--clip", "1,0,0"},
                                                    {"--viewing-distance", "600"}}) {
    EXPECT_THAT(drawn(arguments), ended(ExitCode::Usage, HasSubstr(arguments[0])));
  }
  EXPECT_THAT(drawn({"--size", "641x720"}),
              ended(ExitCode::InvalidInput, HasSubstr("even numbers")));
  EXPECT_THAT(drawn({"--show", "lipps"}),
              ended(ExitCode::InvalidInput, HasSubstr("did you mean 'lips'?")));
  EXPECT_THAT(drawn({"--show", "lips", "--hide", "lips"}),
              ended(ExitCode::InvalidInput, HasSubstr("nothing of the face is left")));
  EXPECT_THAT(drawn({"--section", "0", "--clip", "1,0,0,0"}),
              ended(ExitCode::InvalidInput, HasSubstr("give one of them")));
  EXPECT_THAT(drawn({"--material", "gold"}),
              ended(ExitCode::InvalidInput, AllOf(HasSubstr("'gold'"), HasSubstr("clay"))));
}

TEST_F(FaceVerb, TellsAllMistakesOfAFileOfMaterials) {
  files_.write("mine.json", "{\"skin\": {\"colour\": [1, 2]},\n \"lisp\": {}}");
  EXPECT_THAT(drawn({"--material", "mine.json"}),
              ended(ExitCode::InvalidInput,
                    AllOf(HasSubstr("mine.json:1: /skin/colour"),
                          HasSubstr("mine.json:2: /lisp"),
                          HasSubstr("did you mean \"lips\"?"))));
}

TEST_F(FaceVerb, TellsHowLargeAParticipantSeesThePicture) {
  if (!has_opengl()) GTEST_SKIP() << "no OpenGL here";
  EXPECT_THAT(drawn({"--orthographic", "--viewing-distance", "573", "--picture-height", "100"}),
              ended(ExitCode::Done,
                    AllOf(HasSubstr("for the participant it is 9.97 degrees high"),
                          Not(HasSubstr("from the camera")))));
}

}  // namespace
}  // namespace bimodal
