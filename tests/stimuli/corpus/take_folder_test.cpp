#include "stimuli/corpus/take_folder.hpp"

#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/corpus/spoken_text.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const Clip kSound{Hertz{48'000}, {0.0F, 0.25F, -0.5F}};

std::string add(TakeFolder& folder, const std::string& word, const std::vector<TakeFault>& faults) {
  return folder.add(word, kSound, {}, 0, faults, {"2026-01-31T12:00:00Z", "a device", true});
}

std::vector<nlohmann::json> journal(const fs::path& folder) {
  std::vector<nlohmann::json> lines;
  std::istringstream content{read_file(folder / "takes.jsonl")};
  for (std::string line; std::getline(content, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

std::string message_of(const fs::path& folder) {
  try {
    const TakeFolder opened{folder};
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(TakeFolder, KeepsTheVerySamplesAndWhatIsSaid) {
  const WrittenFiles files;
  const auto place = files.folder() / "anna";
  TakeFolder folder{place};
  EXPECT_EQ(add(folder, "stew", {}), "stew.wav");
  EXPECT_EQ(add(folder, "stew", {TakeFault::Clipped}), "stew-2.wav");
  EXPECT_EQ(read_sound(place / "takes/stew.wav").samples, kSound.samples);
  EXPECT_TRUE(fs::exists(place / "rejected/stew-2.wav"));
  EXPECT_THAT(read_text(place / "takes/stew.txt"), ElementsAre("stew"));
  EXPECT_THAT(folder.good_takes_of("stew"), ElementsAre("stew.wav"));
  const auto lines = journal(place);
  ASSERT_THAT(lines, SizeIs(2));
  EXPECT_EQ(lines[0].at("sha256"), sha256_of_file(place / "takes/stew.wav"));
  EXPECT_EQ(lines[0].at("verdict"), "good");
  EXPECT_EQ(lines[0].at("simulated"), true);
  EXPECT_EQ(lines[1].at("faults"), nlohmann::json::array({"clipped"}));
}

TEST(TakeFolder, IsForItsOwnerOnly) {
  const WrittenFiles files;
  const auto place = files.folder() / "anna";
  TakeFolder folder{place};
  add(folder, "stew", {});
  folder.add_room(kSound, Decibels{-60.0}, {});
  for (const auto* name : {".", "takes", "rejected"}) {
    EXPECT_EQ(fs::status(place / name).permissions(), fs::perms{0700}) << name;
  }
  for (const auto* name : {"takes.jsonl", "room.wav", "takes/stew.wav", "takes/stew.txt"}) {
    EXPECT_EQ(fs::status(place / name).permissions(), fs::perms{0600}) << name;
  }
}

TEST(TakeFolder, MovesWhatIsRejectedAndKept) {
  const WrittenFiles files;
  const auto place = files.folder() / "anna";
  {
    TakeFolder folder{place};
    add(folder, "stew", {});
    add(folder, "zoo", {TakeFault::Quiet});
    folder.reject("stew.wav");
    folder.keep("zoo.wav");
    EXPECT_THROW(folder.keep("cat.wav"), Error);
  }
  const TakeFolder again{place};
  EXPECT_THAT(again.good_takes_of("stew"), IsEmpty());
  EXPECT_THAT(again.good_takes_of("zoo"), ElementsAre("zoo.wav"));
  EXPECT_TRUE(fs::exists(place / "takes/zoo.wav"));
  EXPECT_TRUE(fs::exists(place / "takes/zoo.txt"));
  EXPECT_TRUE(fs::exists(place / "rejected/stew.wav"));
  EXPECT_FALSE(fs::exists(place / "takes/stew.txt"));
}

TEST(TakeFolder, ReplacesATakeInOneLineOfTheJournal) {
  const WrittenFiles files;
  const auto place = files.folder() / "anna";
  {
    TakeFolder folder{place};
    add(folder, "stew", {});
    folder.add("stew", kSound, {}, 0, {TakeFault::Quiet}, {}, "stew.wav");
    EXPECT_THAT(folder.good_takes_of("stew"), ElementsAre("stew.wav"));
    folder.add("stew", kSound, {}, 0, {}, {}, "stew.wav");
    EXPECT_THAT(folder.good_takes_of("stew"), ElementsAre("stew-3.wav"));
    folder.keep("stew-2.wav", "stew-3.wav");
  }
  EXPECT_THAT(journal(place), SizeIs(4));
  EXPECT_THAT(TakeFolder{place}.good_takes_of("stew"), ElementsAre("stew-2.wav"));
  EXPECT_TRUE(fs::exists(place / "takes/stew-2.wav"));
  EXPECT_TRUE(fs::exists(place / "rejected/stew-3.wav"));
}

TEST(TakeFolder, MendsWhatAnInterruptionLeft) {
  const WrittenFiles files;
  const auto place = files.folder() / "anna";
  {
    TakeFolder folder{place};
    add(folder, "stew", {});
    add(folder, "zoo", {});
    add(folder, "cat", {});
  }
  // Killed after the line of a rejection, before the file was moved.
  std::ofstream{place / "takes.jsonl", std::ios::app}
      << R"({"event":"reject","file":"stew.wav"})" << '\n'
      << R"({"event":"take","wo)";  // and while a line was being written
  fs::copy_file(place / "takes/zoo.wav", place / "takes/dog.wav");  // not yet in the journal
  std::ofstream{place / "takes/dog.wav.77.part"} << "half";
  fs::remove(place / "takes/cat.wav");
  {
    TakeFolder folder{place};
    EXPECT_TRUE(fs::exists(place / "rejected/stew.wav"));
    EXPECT_FALSE(fs::exists(place / "takes/dog.wav"));
    EXPECT_TRUE(fs::exists(place / "rejected/dog-unfinished.wav"));
    EXPECT_FALSE(fs::exists(place / "takes/dog.wav.77.part"));
    EXPECT_THAT(folder.good_takes_of("cat"), IsEmpty());
    EXPECT_EQ(add(folder, "stew", {}), "stew-2.wav");
  }
  EXPECT_THAT(journal(place), SizeIs(5));  // every line is whole
  EXPECT_THAT(TakeFolder{place}.good_takes_of("stew"), ElementsAre("stew-2.wav"));
}

TEST(TakeFolder, NamesFilesSafelyAndNeverTwice) {
  const WrittenFiles files;
  TakeFolder folder{files.folder() / "anna"};
  EXPECT_EQ(add(folder, "../../etc/passwd", {}), "______etc_passwd.wav");
  EXPECT_EQ(add(folder, "it's", {}), "it's.wav");
  EXPECT_EQ(add(folder, "stew", {}), "stew.wav");
  EXPECT_EQ(add(folder, "stew-2", {}), "stew-2.wav");
  EXPECT_EQ(add(folder, "stew", {}), "stew-3.wav");
  EXPECT_EQ(add(folder, "\xC3\xA9t\xC3\xA9", {}), "\xC3\xA9t\xC3\xA9.wav");
}

TEST(TakeFolder, IsRefusedWhereItWouldSpoilSomething) {
  const WrittenFiles files;
  files.write("papers/thesis.tex", "...");
  EXPECT_THAT(message_of(files.folder() / "papers"), HasSubstr("in use for something else"));
  EXPECT_FALSE(fs::exists(files.folder() / "papers/takes"));
  files.write("file", "...");
  EXPECT_THAT(message_of(files.folder() / "file"), HasSubstr("cannot keep takes in"));
  const auto place = files.folder() / "anna";
  const TakeFolder open{place};
  EXPECT_THAT(message_of(place), HasSubstr("somebody is recording into it"));
}

TEST(TakeFolder, NamesTheDamagedLine) {
  const WrittenFiles files;
  for (const auto* line : {"nonsense",
                           "[]",
                           "{}",
                           R"({"event":"take","file":"../x.wav"})",
                           R"({"event":"take","file":"x.wav"})",
                           R"({"event":"keep","file":"x.wav"})"}) {
    files.write("anna/takes.jsonl", std::string{"{\"event\":\"session\"}\n"} + line + "\n");
    EXPECT_THAT(message_of(files.folder() / "anna"), HasSubstr("line 2 of takes.jsonl")) << line;
  }
  files.write("anna/takes.jsonl", "{\"event\":\"of the future\"}\n");
  EXPECT_EQ(message_of(files.folder() / "anna"), "no error");
}

}  // namespace
}  // namespace bimodal
