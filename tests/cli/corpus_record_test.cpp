// Whole recording sessions without a microphone: a recording of utterances is spoken in virtual
// time.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/random.hpp"
#include "tests/cli/command_line.hpp"

namespace bimodal {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A quiet room in which a buzz of the given amplitude sounds for 0.4 s in each second.
Clip reading(const std::vector<double>& amplitudes) {
  Random random{1};
  Clip made{Hertz{48'000}, {}};
  for (const double amplitude : amplitudes) {
    for (int i = 0; i < 48'000; ++i) {
      const bool speaks = i >= 24'000 && i < 43'200;
      const double buzz = speaks ? amplitude * (i % 300 < 150 ? 1.0 : -1.0) : 0.0;
      made.samples.push_back(static_cast<float>(0.0005 * random.normal() + buzz));
    }
  }
  for (int i = 0; i < 24'000; ++i) {
    made.samples.push_back(static_cast<float>(0.0005 * random.normal()));
  }
  return made;
}

class CorpusRecord : public CommandLine {
 protected:
  /// A talker who says every word well.
  CorpusRecord() { write_wav(files_.folder() / "reading.wav", reading({0.1, 0.12})); }

  static std::vector<std::string> arguments(const std::vector<std::string>& more) {
    std::vector<std::string> all{"corpus",
                                 "record",
                                 "-o",
                                 "anna",
                                 "--input",
                                 "simulated:reading.wav",
                                 "--display",
                                 "headless",
                                 "--answers",
                                 "simulated"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  [[nodiscard]] std::vector<nlohmann::json> journal(const std::string& event) const {
    std::vector<nlohmann::json> lines;
    std::istringstream content{bytes("anna/takes.jsonl")};
    for (std::string line; std::getline(content, line);) {
      auto json = nlohmann::json::parse(line);
      if (json.at("event") == event) lines.push_back(std::move(json));
    }
    return lines;
  }
};

TEST_F(CorpusRecord, RecordsAListAndTellsHowToGoOn) {
  EXPECT_THAT(
      bimodal(arguments({"--word", "stew", "--word", "zoo", "--word", "stew"})),
      ended(ExitCode::Done,
            AllOf(HasSubstr("0 of 2 takes recorded"),
                  HasSubstr("stew.wav: good"),
                  HasSubstr("complete: 2 of 2 takes recorded, in anna/takes"),
                  HasSubstr("bimodal corpus build anna/takes/*.wav --words anna/words.txt"))));
  EXPECT_EQ(bytes("anna/words.txt"), "stew\nzoo\n");
  const auto takes = journal("take");
  ASSERT_EQ(takes.size(), 2U);
  for (const auto& take : takes) {
    const auto file = "anna/takes/" + take.at("file").get<std::string>();
    EXPECT_EQ(take.at("sha256"), sha256_of_file(files_.folder() / file));
    EXPECT_EQ(take.at("simulated"), true);
    EXPECT_GT(take.at("snr_db"), 40.0);
  }
  // A square wave of 0.1 has an RMS and a peak of -20 dB; the room is 46 dB below.
  // The speech is found in steps of 10 ms: one more at either end of 400 ms takes 0.21 dB away.
  EXPECT_NEAR(takes[0].at("level_dbfs"), -20.0, 0.22);
  EXPECT_NEAR(takes[0].at("peak_dbfs"), -20.0, 0.3);
  EXPECT_EQ(bytes("anna/takes/zoo.txt"), "zoo\n");
  EXPECT_EQ(journal("room").size(), 1U);
  EXPECT_EQ(fs::status(files_.folder() / "anna").permissions(), fs::perms{0700});
  EXPECT_THAT(bimodal(arguments({"--word", "stew", "--word", "zoo"})),
              ended(ExitCode::Done, HasSubstr("every word is recorded")));
}

TEST_F(CorpusRecord, AsksAgainAndPassesOverWhatStaysDoubtful) {
  write_wav(files_.folder() / "reading.wav", reading({0.01}));
  EXPECT_THAT(bimodal(arguments({"--word", "stew"})),
              ended(ExitCode::Findings,
                    AllOf(HasSubstr("stew-3.wav: doubtful, quiet"),
                          HasSubstr("stopped: 0 of 1 take"),
                          HasSubstr("the same command goes on"))));
  EXPECT_TRUE(fs::exists(files_.folder() / "anna/rejected/stew.wav"));
  EXPECT_TRUE(fs::is_empty(files_.folder() / "anna/takes"));
}

TEST_F(CorpusRecord, GoesOnAfterBeingKilledWithoutLosingAStoredTake) {
  std::vector<std::string> words;
  for (int i = 0; i < 60; ++i) {
    words.insert(words.end(), {"--word", "word" + std::to_string(i)});
  }
  std::size_t before = 0;
  for (const auto* seen : {"word3.wav: good", "word17.wav: good", "word31.wav: good"}) {
    StartedCommand session{files_.folder(), "bimodal", arguments(words)};
    ASSERT_TRUE(session.await(seen));
    session.kill_at_once();
    EXPECT_EQ(session.end().exit_code, -1);
    const auto stored = journal("take").size();
    EXPECT_GT(stored, before);
    EXPECT_LT(stored, 60U);
    before = stored;
  }
  const auto rest = bimodal(arguments(words));
  EXPECT_THAT(rest,
              ended(ExitCode::Done,
                    AllOf(HasSubstr(std::to_string(before) + " of 60 takes recorded"),
                          HasSubstr("complete: 60 of 60"),
                          Not(HasSubstr("word3.wav")))));
  std::size_t recordings = 0;
  for (const auto& entry : fs::directory_iterator{files_.folder() / "anna/takes"}) {
    recordings += entry.path().extension() == ".wav" ? 1U : 0U;
  }
  EXPECT_EQ(recordings, 60U);
  for (const auto& take : journal("take")) {
    EXPECT_EQ(take.at("sha256"),
              sha256_of_file(files_.folder() / "anna/takes" / take.at("file").get<std::string>()));
  }
}

TEST_F(CorpusRecord, OrdersWordsAtRandomFromTheSeedAlone) {
  const auto order = [&](const std::string& folder, const std::string& seed) {
    auto all = arguments({"--words", "practice-12", "--order", "random", "--seed", seed});
    std::ranges::replace(all, "anna", folder);
    EXPECT_EQ(bimodal(all).exit_code, 0);
    std::vector<std::string> words;
    std::istringstream content{bytes(folder + "/takes.jsonl")};
    for (std::string line; std::getline(content, line);) {
      const auto json = nlohmann::json::parse(line);
      if (json.at("event") == "take") words.push_back(json.at("word"));
    }
    return words;
  };
  const auto one = order("one", "7");
  EXPECT_EQ(one.size(), 12U);
  EXPECT_EQ(order("two", "7"), one);
  EXPECT_NE(order("three", "8"), one);
}

TEST_F(CorpusRecord, RecordsEveryWordSoOftenAsAsked) {
  EXPECT_THAT(bimodal(arguments({"--word", "stew", "--word", "zoo", "--repeats", "2", "--auto"})),
              ended(ExitCode::Done, HasSubstr("complete: 4 of 4")));
  EXPECT_TRUE(fs::exists(files_.folder() / "anna/takes/stew-2.wav"));
  EXPECT_EQ(bytes("anna/takes/stew-2.txt"), "stew\n");
  EXPECT_THAT(bimodal(arguments({"--word", "stew", "--word", "zoo", "--repeats", "3"})),
              ended(ExitCode::Done, HasSubstr("4 of 6 takes recorded")));
}

TEST_F(CorpusRecord, RefusesWhatCannotBeBeforeItMakesAnything) {
  EXPECT_THAT(bimodal(arguments({})), ended(ExitCode::InvalidInput, HasSubstr("--words LIST")));
  EXPECT_THAT(bimodal(arguments({"--words", "monosyllabels"})),
              ended(ExitCode::InvalidInput, HasSubstr("monosyllabels")));
  EXPECT_THAT(
      bimodal({"corpus", "record", "-o", "anna", "--word", "stew", "--display", "headless"}),
      ended(ExitCode::InvalidInput, HasSubstr("--answers simulated")));
  files_.write("reading.wav", "no sound");
  EXPECT_THAT(bimodal(arguments({"--word", "stew"})),
              ended(ExitCode::InvalidInput, HasSubstr("reading.wav")));
  EXPECT_FALSE(fs::exists(files_.folder() / "anna"));
}

TEST_F(CorpusRecord, WithoutAMicrophoneTellsWhatToDo) {
  const auto run = bimodal({"corpus",
                            "record",
                            "-o",
                            "anna",
                            "--word",
                            "stew",
                            "--device",
                            "no such device",
                            "--display",
                            "headless",
                            "--answers",
                            "simulated"});
  EXPECT_THAT(run, ended(ExitCode::Device, HasSubstr("--input simulated:FILE")));
  EXPECT_FALSE(fs::exists(files_.folder() / "anna"));
}

}  // namespace
}  // namespace bimodal
