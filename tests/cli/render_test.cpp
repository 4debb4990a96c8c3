// The face in films and pictures on the command line.

#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "stimuli/picture/image.hpp"
#include "tests/cli/command_line.hpp"
#include "tests/stimuli/video/made_media.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

class Render : public CommandLine {
 protected:
  /// With small pictures, so that tests are fast.
  [[nodiscard]] Ended render(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all{"render", "--height", "90"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return bimodal(all);
  }

  [[nodiscard]] std::string probed(const std::string& name, const std::string& entry) const {
    return made_media::printed(
        fmt::format("ffprobe -v error -count_frames -select_streams {} -show_entries stream={} -of "
                    "default=nw=1:nk=1 '{}'",
                    entry.starts_with("codec") ? "a" : "v",
                    entry,
                    path(name)));
  }

  /// Nothing but what the test wrote is in the folder.
  [[nodiscard]] bool has_only(const std::vector<std::string>& names) const {
    std::size_t found = 0;
    for (const auto& entry : std::filesystem::directory_iterator{files_.folder()}) {
      const auto name = entry.path().filename().string();
      if (name == "two.json" || std::ranges::find(names, name) != names.end()) ++found;
    }
    const auto count = std::distance(std::filesystem::directory_iterator{files_.folder()},
                                     std::filesystem::directory_iterator{});
    return found == static_cast<std::size_t>(count);
  }
};

TEST_F(Render, ATextIsAFilmInEveryForm) {
  if (!made_media::have("ffprobe")) GTEST_SKIP() << "the programs of FFmpeg are absent";
  // Intrinsic durations: 790 ms with the rest around.
  ASSERT_THAT(
      render({"stew", "-o", "a.mp4", "-o", "b.WEBM", "-o", "c.gif"}),
      ended(ExitCode::Done, HasSubstr("not 60: frames of this form last whole hundredths")));
  EXPECT_EQ(probed("a.mp4", "nb_read_frames"), "48\n");
  EXPECT_EQ(probed("b.WEBM", "nb_read_frames"), "48\n");
  EXPECT_EQ(probed("c.gif", "nb_read_frames"), "40\n");
  EXPECT_EQ(probed("a.mp4", "width,height"), "80\n90\n");
}

TEST_F(Render, WithAudioTheVoiceTimesTheFace) {
  if (!made_media::have("ffprobe")) GTEST_SKIP() << "the programs of FFmpeg are absent";
  ASSERT_THAT(render({"stew", "--audio", "-o", "stew.mp4", "-o", "stew.wav", "--fps", "25"}),
              ended(ExitCode::Done, AllOf(HasSubstr("with sound"), HasSubstr("of the voice"))));
  EXPECT_EQ(probed("stew.mp4", "codec_name"), "aac\n");
  EXPECT_EQ(probed("stew.mp4", "avg_frame_rate"), "25/1\n");
  const auto sound = std::stod(made_media::printed(
      fmt::format("ffprobe -v error -show_entries format=duration -of default=nw=1:nk=1 '{}'",
                  path("stew.wav"))));
  const auto picture = std::stod(probed("stew.mp4", "duration"));
  EXPECT_GE(picture, sound);
  EXPECT_LT(picture, sound + 0.04 + 1e-6);
}

TEST_F(Render, ASoundOfOnesOwnMayLastLonger) {
  if (!made_media::have("ffprobe")) GTEST_SKIP() << "the programs of FFmpeg are absent";
  ASSERT_THAT(render({"stew", "-o", "voice.wav", "--rate", "0.5"}),
              ended(ExitCode::Done, HasSubstr("voice.wav")));
  ASSERT_THAT(render({"AA", "--from", "arpabet", "--audio", "voice.wav", "-o", "aa.webm"}),
              ended(ExitCode::Done, HasSubstr("with sound")));
  EXPECT_EQ(probed("aa.webm", "codec_name"), "opus\n");
  EXPECT_GT(std::stoi(probed("aa.webm", "nb_read_frames")), 90);
}

TEST_F(Render, APictureHasThePhonesSideBySideOrOneInstant) {
  ASSERT_THAT(render({"B~W:3/8 AA", "--from", "arpabet", "-o", "strip.png"}),
              ended(ExitCode::Done, AllOf(HasSubstr("B~W:3/8"), HasSubstr("4 pictures"))));
  const auto strip = read_png(path("strip.png"));
  EXPECT_EQ(strip.width, 4 * 80);
  ASSERT_THAT(render({"stew", "--at", "300", "-o", "at.PNG"}),
              ended(ExitCode::Done, HasSubstr("the face at 300 ms")));
  EXPECT_EQ(read_png(path("at.PNG")).width, 80);
}

TEST_F(Render, FramesGoToAFolderOrToNumberedNames) {
  ASSERT_THAT(render({"stew", "-o", "frames/", "--fps", "20"}),
              ended(ExitCode::Done, HasSubstr("16 frames")));
  ASSERT_THAT(render({"stew", "-o", "stew%03d.png", "--fps", "20"}),
              ended(ExitCode::Done, HasSubstr("16 frames")));
  EXPECT_EQ(bytes("frames/frame0015.png"), bytes("stew015.png"));
  EXPECT_FALSE(std::filesystem::exists(path("stew016.png")));
  EXPECT_THAT(render({"AA", "--from", "arpabet", "-o", "frames", "--fps", "10"}),
              ended(ExitCode::Done, HasSubstr("are of an earlier film")));
}

TEST_F(Render, TracksAreDrawnAsTheyAre) {
  ASSERT_THAT(bimodal({"tracks", "stew", "-o", "stew.csv"}), ended(ExitCode::Done, HasSubstr("")));
  ASSERT_THAT(bimodal({"tracks", "stew", "-o", "stew.json"}), ended(ExitCode::Done, HasSubstr("")));
  for (const std::string said : {"stew", "stew.csv", "stew.json"}) {
    ASSERT_THAT(render({said, "--at", "300", "-o", said + ".png"}),
                ended(ExitCode::Done, Not(HasSubstr("note"))));
  }
  EXPECT_EQ(bytes("stew.png"), bytes("stew.csv.png"));
  EXPECT_EQ(bytes("stew.png"), bytes("stew.json.png"));
  EXPECT_THAT(render({"stew.json", "-o", "strip.png"}),
              ended(ExitCode::Done, HasSubstr("5 pictures")));
  EXPECT_THAT(render({"stew.csv", "-o", "strip.png"}),
              ended(ExitCode::InvalidInput, HasSubstr("--at")));
}

TEST_F(Render, TracksAreInterpolatedAndHeldToTheFacesRange) {
  files_.write("jaw.csv", "time_s,jaw,lip_closure\n0,0,0\n0.1,30,0\n");
  files_.write("half.csv", "time_ms,jaw\n0,6\n1000,6\n");
  ASSERT_THAT(render({"jaw.csv", "--at", "20", "-o", "a.png"}),
              ended(ExitCode::Done, HasSubstr("jaw goes from 0 to 30; the face shows 0 to")));
  ASSERT_THAT(render({"half.csv", "--at", "20", "-o", "b.png"}),
              ended(ExitCode::Done, Not(HasSubstr("note"))));
  EXPECT_EQ(bytes("a.png"), bytes("b.png"));
}

TEST_F(Render, TellsWhatIsWrongWithTracks) {
  const auto refused = [&](const std::string& name, const std::string& text) {
    files_.write(name, text);
    return render({name, "-o", "x.mp4"});
  };
  const auto with = [](const auto& matcher) { return ended(ExitCode::InvalidInput, matcher); };
  EXPECT_THAT(refused("t.csv", "time_ms,jaw\n0,1\n10,nan\n20,x\n"),
              with(AllOf(HasSubstr("t.csv:3: jaw \"nan\" is no finite number"),
                         HasSubstr("t.csv:4: jaw \"x\" is no finite number"))));
  EXPECT_THAT(refused("t.csv", "time_ms,jaw\n0,1\n10\n"),
              with(HasSubstr("t.csv:3: 1 fields, but the first line has 2")));
  EXPECT_THAT(refused("t.csv", "time_ms,jaw\n10,1\n0,1\n"),
              with(HasSubstr("does not come after the one before it")));
  EXPECT_THAT(refused("t.csv", "jaw,lip_width\n0,1\n10,1\n"),
              with(HasSubstr("there is no column time_ms or time_s")));
  EXPECT_THAT(refused("t.csv", "time_ms,jow\n0,1\n10,1\n"),
              with(HasSubstr("none of its columns is a control of the face; did you mean 'jaw'?")));
  EXPECT_THAT(refused("t.csv", "time_ms,jow,jaw\n0,1,1\n10,1\n"),
              with(AllOf(HasSubstr("did you mean 'jaw'?"), HasSubstr("t.csv:3: 2 fields"))));
  EXPECT_THAT(refused("t.csv", ""), with(HasSubstr("the file is empty")));
  EXPECT_THAT(refused("t.csv", "time_ms,jaw\n-20,1\n-10,1\n"), with(HasSubstr("before time 0")));
  EXPECT_THAT(refused("t.csv", "time_ms,jaw\n0,1\n1e12,1\n"), with(HasSubstr("an hour at most")));
  EXPECT_THAT(refused("t.json", R"({"time_ms": [0, 1], "controls": {"jaw": [0, null]}})"),
              with(HasSubstr("t.json:1: /controls/jaw/1")));
  EXPECT_THAT(refused("t.json", R"({"time_ms": [0, 1], "controls": {"jaw": [0]}})"),
              with(HasSubstr("it has 1 values, and there are 2 instants")));
  EXPECT_THAT(refused("t.json", R"({"time_ms": [0, 0], "controls": {"jaw": [0, 1]}})"),
              with(HasSubstr("/time_ms/1")));
  EXPECT_THAT(refused("t.json", R"({"time_ms": 3, "controls": 4})"), with(HasSubstr("/time_ms")));
  EXPECT_TRUE(has_only({"t.csv", "t.json"}));
}

TEST_F(Render, RefusesWhatCannotBeBeforeItDraws) {
  const auto wrong = [&](const std::vector<std::string>& arguments, const std::string& words) {
    EXPECT_THAT(render(arguments), ended(ExitCode::InvalidInput, HasSubstr(words)));
  };
  wrong({"stew", "-o", "stew"}, "end the name with .mp4");
  wrong({"stew", "-o", "x.avi"}, ".webm");
  wrong({"stew", "-o", "x.png", "--at", "1e5"}, "begins at 0 and ends at 790.0 ms");
  wrong({"stew", "-o", "x.png", "--at", "-1"}, "give an instant between");
  wrong({"stew", "-o", "x%s.png"}, "%04d");
  wrong({"stew", "-o", "x%04d.mp4"}, "numbered frames are written as PNG");
  wrong({"stew", "-o", "x.gif", "--audio"}, "--audio has no effect");
  wrong({"stew", "-o", "x.mp4", "--at", "3"}, "--at has no effect");
  wrong({"stew", "-o", "x.gif", "--crf", "3"}, "--crf has no effect");
  wrong({"stew", "-o", "x.mp4", "--size", "641x720"}, "even numbers");
  wrong({"stew", "-o", "x.mp4", "--crf", "60"}, "from 0 to 51");
  wrong({"stew", "-o", "x.mp4", "--audio", "--method", "nrl"}, "--method nrl has no voice");
  wrong({"B~W:3/8 AA", "--from", "arpabet", "-o", "x.wav"}, "ambiguous sound B~W:3/8");
  wrong({"S:140 AA", "--from", "arpabet", "-o", "x.mp4", "--audio"}, "leave durations");
  wrong({"none.csv", "-o", "x.mp4"}, "none.csv");
  files_.write("long.csv", "time_ms,jaw\n0,1\n3000000,1\n");
  wrong({"long.csv", "-o", "x.gif"}, "a GIF of this size 37282 at most");
  files_.write("t.csv", "time_ms,jaw\n0,1\n10,1\n");
  wrong({"t.csv", "-o", "x.mp4", "--audio"}, "--audio FILE.wav");
  wrong({"t.csv", "-o", "x.mp4", "--rate", "2"}, "which are drawn as they are");
  const auto misused = [&](const std::vector<std::string>& arguments, const std::string& words) {
    EXPECT_THAT(bimodal(arguments), ended(ExitCode::Usage, HasSubstr(words)));
  };
  misused({"render", "stew"}, "--output is required");
  misused({"render", "stew", "-o", "nowhere/x.mp4"}, "there is no folder");
  misused({"render", "--audio", "stew", "-o", "x.mp4"}, "--audio last for the voice");
  misused({"render", "stew", "-o", "x.mp4", "--fps", "nan"}, "30000/1001");
  EXPECT_TRUE(has_only({"t.csv", "long.csv"}));
}

TEST_F(Render, TakesNoFileOfAnotherKindForAText) {
  for (const std::string name : {"mine.wav", "MINE.MP4", "mine.png", "text.txt"}) {
    files_.write(name, "x");
    EXPECT_THAT(render({name, "-o", "x.mp4"}),
                ended(ExitCode::InvalidInput,
                      AllOf(HasSubstr("'" + name + "' is a file or folder, but no score"),
                            HasSubstr("--audio"))));
  }
}

TEST_F(Render, LeavesNothingHalfWrittenWhenItIsInterrupted) {
  StartedCommand command{files_.folder(),
                         "bimodal",
                         {"render", "blickety", "--rate", "0.3", "--fps", "1000", "-o", "x.mp4"}};
  ASSERT_TRUE(command.await("not in the dictionary"));
  command.interrupt();
  EXPECT_THAT(command.end(), ended(ExitCode::InvalidInput, HasSubstr("'x.mp4' is not written")));
  EXPECT_TRUE(has_only({}));
}

}  // namespace
}  // namespace bimodal
