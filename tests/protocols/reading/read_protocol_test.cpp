#include "protocols/reading/read_protocol.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/digest.hpp"
#include "tests/protocols/reading/reading.hpp"

namespace bimodal::protocols {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST_F(Reading, GivesTheModelOfAGoodProtocol) {
  const auto read = this->read(std::string{kGood});
  EXPECT_THAT(messages(std::string{kGood}), IsEmpty());
  EXPECT_EQ(read.text, kGood);
  EXPECT_EQ(read.sha256, sha256(kGood));
  EXPECT_EQ(read.protocol.title, "Test");
  EXPECT_EQ(read.protocol.seed, 7U);
  ASSERT_EQ(read.protocol.conditions.size(), 2U);
  const auto& [heard, seen] = std::pair{read.protocol.conditions[0], read.protocol.conditions[1]};
  EXPECT_EQ(heard.name, "a");
  EXPECT_EQ(heard.auditory_talker, "festival:slt");
  EXPECT_EQ(heard.visual_talker, std::nullopt);
  EXPECT_EQ(heard.timing_talker, "festival:slt");
  EXPECT_EQ(heard.snr, Decibels{-8});
  EXPECT_EQ(seen.auditory_talker, std::nullopt);
  EXPECT_EQ(seen.visual_talker, "face");
  EXPECT_EQ(seen.timing_talker, "festival:kal");
  EXPECT_EQ(seen.snr, std::nullopt);
  EXPECT_EQ(read.words.name, "test.json#/words");
  EXPECT_THAT(read.words.words,
              ElementsAre(Word{"cat", {Phone::K, Phone::AE, Phone::T}},
                          Word{"dog", {Phone::D, Phone::AO, Phone::G}}));
}

TEST_F(Reading, ReadsEveryKey) {
  const auto read = this->read(R"({
    "bimodal_protocol": 1, "title": "T", "description": "D\nE", "seed": 9007199254740991,
    "instructions": ["one", "two\n"], "words": ["cat"],
    "conditions": [{"name": "v", "auditory": null, "visual": {"talker": "face"},
                    "timing": {"talker": "festival:slt"}, "snr_db": null}],
    "assignment": "every-condition", "practice": {"words": ["fish"]},
    "breaks": {"every_trials": 69, "text": "Rest"},
    "response": {"kind": "typed", "prompt": "?", "time_limit_s": 12.5, "longest": 41},
    "intervals": {"fixation_s": 0.1, "lead_s": 0.2, "trail_s": 0.3, "pause_s": 0.4,
                  "av_offset_ms": -33.3},
    "sound": {"rate_hz": 44100, "speech_level_dbfs": -30.5,
              "noise": {"kind": "white", "band_hz": [100, 4000.5], "lead_s": 0.6, "trail_s": 0.7,
                        "ramp_ms": 20}},
    "window": {"width": 1000, "height": 900, "fullscreen": false, "face_height": 800,
               "background": "#0aBc01", "face_quality": "full"},
    "farewell": "Bye"})");
  using namespace std::chrono_literals;
  const auto& p = read.protocol;
  EXPECT_FALSE(has_errors(read.diagnostics));
  EXPECT_EQ(p.description, "D\nE");
  EXPECT_EQ(p.seed, 9007199254740991U);
  EXPECT_THAT(p.instructions, ElementsAre("one", "two\n"));
  EXPECT_EQ(p.conditions.at(0).timing_talker, "festival:slt");
  EXPECT_EQ(p.assignment, Assignment::EveryCondition);
  EXPECT_THAT(p.practice.words, ElementsAre("fish"));
  EXPECT_THAT(read.practice, ElementsAre(Word{"fish", {Phone::F, Phone::IH, Phone::SH}}));
  EXPECT_EQ(p.breaks.every_trials, 69);
  EXPECT_EQ(p.breaks.text, "Rest");
  EXPECT_EQ(p.response.prompt, "?");
  EXPECT_EQ(p.response.time_limit, Duration{12'500ms});
  EXPECT_EQ(p.response.longest, 41);
  EXPECT_EQ(p.intervals.fixation, Duration{100ms});
  EXPECT_EQ(p.intervals.lead, Duration{200ms});
  EXPECT_EQ(p.intervals.trail, Duration{300ms});
  EXPECT_EQ(p.intervals.pause, Duration{400ms});
  EXPECT_EQ(p.intervals.av_offset, Duration{-33'300us});
  EXPECT_EQ(p.sound.rate, Hertz{44'100});
  EXPECT_EQ(p.sound.speech_level, Decibels{-30.5});
  EXPECT_EQ(p.sound.noise.band_low, Hertz{100});
  EXPECT_EQ(p.sound.noise.band_high, Hertz{4000.5});
  EXPECT_EQ(p.sound.noise.lead, Duration{600ms});
  EXPECT_EQ(p.sound.noise.trail, Duration{700ms});
  EXPECT_EQ(p.sound.noise.ramp, Duration{20ms});
  EXPECT_EQ(p.window.width, 1000);
  EXPECT_EQ(p.window.height, 900);
  EXPECT_FALSE(p.window.fullscreen);
  EXPECT_EQ(p.window.face_height, 800);
  EXPECT_EQ(p.window.background, 0x0ABC01U);
  EXPECT_EQ(p.window.face_quality, FaceQuality::Full);
  EXPECT_EQ(p.farewell, "Bye");
}

TEST_F(Reading, SaysWhatIsNotANumber) {
  EXPECT_THAT(messages("-8", "\"loud\""),
              ElementsAre("test.json:7: /conditions/0/snr_db: \"loud\" is not a number; give the "
                          "ratio in dB, e.g. -8"));
}

TEST_F(Reading, SuggestsTheNearestKeyForAnUnknownOne) {
  EXPECT_THAT(messages("snr_db", "snrdb"),
              ElementsAre("test.json:7: /conditions/0/snrdb: the key \"snrdb\" is not known; did "
                          "you mean \"snr_db\"? Known here: \"name\", \"optional\", "
                          "\"auditory\", \"visual\", \"timing\", \"snr_db\", "
                          "\"av_offset_ms\", \"manner\""));
  EXPECT_THAT(with("\"brakes\": {}"), ElementsAre(HasSubstr("did you mean \"breaks\"?")));
  EXPECT_THAT(with("\"zebra\": {}"), ElementsAre(Not(HasSubstr("did you mean"))));
}

TEST_F(Reading, TellsOfEveryMistakeAtOnceInTheOrderOfTheLines) {
  const auto all = messages(R"({
    "bimodal_protocol": 1,
    "seed": 1.5,
    "words": "no-such-list",
    "window": {"width": 100,
               "fullscreen": "yes"},
    "conditions": [
      {"name": "", "auditory": {"talker": "festival:kel"}},
      {"name": "x"}, 7],
    "sound": {"noise": {"band_hz": [8000, 80]}},
    "response": {"kind": "spoken"},
    "farewel": ""
  })");
  EXPECT_THAT(
      all,
      ElementsAre(
          "test.json:1: the key \"title\" is missing; add \"title\": \"My experiment\"",
          HasSubstr("test.json:3: /seed: 1.5 is not a whole number"),
          HasSubstr("test.json:4: /words: the library has no word list \"no-such-list\""),
          HasSubstr("test.json:5: /window/width: 100 is outside 320 to 8192"),
          HasSubstr("test.json:6: /window/fullscreen: \"yes\" is not true or false"),
          HasSubstr("test.json:8: /conditions/0/name: the text is empty"),
          HasSubstr(
              "test.json:8: /conditions/0/auditory/talker: \"festival:kel\" is not known; did "
              "you mean \"festival:kal\"?"),
          HasSubstr("test.json:9: /conditions/1: nothing is heard and nothing is seen"),
          HasSubstr("test.json:9: /conditions/2: 7 is not an object"),
          HasSubstr("test.json:9: /conditions/2: nothing"),
          HasSubstr("test.json:10: /sound/noise/band_hz: the lower edge, 8000 Hz, is not below"),
          HasSubstr("test.json:11: /response/kind: \"spoken\" is not known"),
          HasSubstr("test.json:12: /farewel: the key \"farewel\" is not known; did you mean "
                    "\"farewell\"?")));
}

TEST_F(Reading, LetsTheMachineDecideHowFinelyTheFaceIsDrawnUnlessItIsSaid) {
  EXPECT_EQ(read(std::string{kGood}).protocol.window.face_quality, FaceQuality::Auto);
  EXPECT_THAT(with(R"("window": {"face_quality": "ful"})"),
              ElementsAre(AllOf(HasSubstr("/window/face_quality: \"ful\" is not known"),
                                HasSubstr("did you mean \"full\"?"))));
}

TEST_F(Reading, SaysWhereTheTextIsNotJson) {
  EXPECT_THAT(messages("\"seed\": 7,", "\"seed\": 7"),
              ElementsAre(HasSubstr("test.json:5: not JSON: column 3: ")));
  EXPECT_THAT(messages(""), ElementsAre(HasSubstr("test.json: the file is empty")));
}

TEST_F(Reading, SaysThatAFileIsMissingOrNotAFile) {
  const auto message = [](const std::filesystem::path& file) {
    return describe(read_protocol(file).diagnostics.at(0));
  };
  EXPECT_THAT(
      message(files_.folder() / "none.json"),
      HasSubstr("none.json: cannot read the protocol: there is no such file; give the path"));
  EXPECT_THAT(message(files_.folder()), HasSubstr("it is a folder"));
  EXPECT_THAT(message("/dev/zero"), HasSubstr("it is not an ordinary file"));
}

TEST_F(Reading, RefusesAnotherFormat) {
  EXPECT_THAT(messages("protocol\": 1", "protocol\": 2"),
              ElementsAre("test.json:2: /bimodal_protocol: written for a newer Bimodal: format 2, "
                          "and this one reads up to 1; update Bimodal"));
  EXPECT_THAT(messages("protocol\": 1", "protocol\": 0"), ElementsAre(HasSubstr("0 is outside")));
  EXPECT_THAT(messages("  \"bimodal_protocol\": 1,", ""),
              ElementsAre(HasSubstr("test.json:1: the key \"bimodal_protocol\" is missing")));
}

TEST_F(Reading, RefusesAKeyThatIsGivenTwice) {
  EXPECT_THAT(messages("\"seed\": 7,", "\"seed\": 7,\n \"seed\": 8,"),
              ElementsAre("test.json:5: /seed: the same key is already on line 4; remove one of "
                          "them"));
}

TEST_F(Reading, RefusesAWordWithoutPronunciation) {
  EXPECT_THAT(messages("\"Dog\"", "\n\"cat's\",\"zyzzyva\""),
              ElementsAre(HasSubstr("test.json:6: /words/1: \"cat's\" has no pronunciation"),
                          HasSubstr("test.json:6: /words/2: \"zyzzyva\" has no pronunciation in "
                                    "the dictionary; check its spelling, or give its phones")));
}

TEST_F(Reading, RefusesAWordThatIsGivenTwiceInAnyCase) {
  EXPECT_THAT(messages("\"Dog\"", "\"CAT\""),
              Contains(HasSubstr("test.json:5: /words/1: \"cat\" is already at /words/0")));
}

TEST_F(Reading, SaysOnceThatThereIsNoDictionary) {
  const auto read = read_protocol_text(
      std::string{kGood}, "test.json", {.dictionary = files_.folder() / "none.dict"});
  ASSERT_EQ(read.diagnostics.size(), 1U);
  EXPECT_THAT(describe(read.diagnostics[0]), HasSubstr("cannot be looked up"));
  EXPECT_THAT(describe(read.diagnostics[0]), HasSubstr("none.dict"));
}

TEST_F(Reading, ReadsAWordListBesideTheProtocol) {
  files_.write("lists/mine.json",
               R"({"words": [{"word": "moon", "phones": ["M", "UW", "N"]},
                              {"word": "cat", "phones": ["K", "AE", "T"]}]})");
  std::string text{kGood};
  text.replace(text.find(R"(["cat", "Dog"])"), 14, R"("lists/mine.json")");
  const auto read = this->read(text);
  EXPECT_THAT(read.diagnostics, IsEmpty());
  EXPECT_EQ(read.words.name, "lists/mine.json");
  EXPECT_EQ(read.protocol.words, "lists/mine.json");
  EXPECT_EQ(read.words.words.size(), 2U);
}

TEST_F(Reading, CarriesOverTheMistakesOfAWordList) {
  files_.write("bad.json",
               "{\"words\": [\n{\"word\": \"moon\"},\n{\"word\": \"cat\", \"phones\": [\"Q\"]}]}");
  const auto all = messages(R"(["cat", "Dog"])", R"("bad.json")");
  EXPECT_THAT(all,
              Contains(HasSubstr("test.json:5: /words: the word list 'bad.json' has mistakes")));
  EXPECT_THAT(all, Contains(HasSubstr("bad.json:2: /words/0")));
  EXPECT_THAT(all, Contains(HasSubstr("bad.json:3: /words/1/phones")));
}

TEST_F(Reading, SaysThatAWordListIsMissing) {
  EXPECT_THAT(messages(R"(["cat", "Dog"])", R"("lists/none.json")"),
              ElementsAre(HasSubstr("test.json:5: /words: cannot read the word list "
                                    "'lists/none.json': there is no such file")));
  EXPECT_THAT(messages(R"(["cat", "Dog"])", R"("/dev/zero")"),
              ElementsAre(HasSubstr("it is not an ordinary file")));
  EXPECT_THAT(messages(R"(["cat", "Dog"])", R"("monosylables-414")"),
              ElementsAre(HasSubstr("did you mean \"monosyllables-414\"?")));
}

TEST_F(Reading, SurvivesAWordListThatIsHostile) {
  files_.write("deep.json", std::string(1'000'000, '['));
  EXPECT_THAT(messages(R"(["cat", "Dog"])", R"("deep.json")"),
              Contains(HasSubstr("test.json:5: /words: ")));
  files_.write("large.json", R"({"words": [{"word": 1e999, "phones": []}]})");
  EXPECT_THAT(messages(R"(["cat", "Dog"])", R"("large.json")"),
              Contains(HasSubstr("test.json:5: /words: ")));
}

TEST_F(Reading, JudgesConditionsTogether) {
  EXPECT_THAT(messages("\"v\"", "\"a\""),
              ElementsAre(HasSubstr("test.json:8: /conditions/1/name: \"a\" is already the name of "
                                    "condition 0")));
  EXPECT_THAT(messages("\"visual\": {\"talker\": \"face\"}",
                       "\"visual\": {\"talker\": \"face\"}, \"snr_db\": 3"),
              ElementsAre(HasSubstr("/conditions/1/snr_db: there is a speech-to-noise ratio but no "
                                    "speech")));
  EXPECT_THAT(messages("\"snr_db\": -8", "\"timing\": {\"talker\": \"festival:kal\"}"),
              ElementsAre(HasSubstr("/conditions/0/timing: where a voice is heard")));
  EXPECT_THAT(messages("-8", "-60.5"), ElementsAre(HasSubstr("-60.5 is outside -60 to 60")));
}

TEST_F(Reading, JudgesSoundAndScreenTogether) {
  EXPECT_THAT(
      with(R"("sound": {"rate_hz": 12000})"),
      ElementsAre(HasSubstr("test.json:2: /sound/noise/band_hz: the upper edge, 8000 Hz, is "
                            "above half the sampling rate, 6000 Hz")));
  EXPECT_THAT(with(R"("sound": {"rate_hz": 16000})"), IsEmpty());
  EXPECT_THAT(with(R"("sound": {"noise": {"lead_s": 0.01}})"),
              ElementsAre(HasSubstr("/sound/noise/ramp_ms: ramps of 50 ms are longer")));
  EXPECT_THAT(with(R"("window": {"height": 719})"),
              ElementsAre(HasSubstr("/window/face_height: the face, 720 pixels high, is higher")));
  EXPECT_THAT(with(R"("window": {"width": 639})"),
              ElementsAre(HasSubstr("the face, 640 pixels wide (8/9 of its height), is wider")));
  EXPECT_THAT(with(R"("window": {"width": 640, "height": 720})"), IsEmpty());
  EXPECT_THAT(with(R"("window": {"background": "grey"})"),
              ElementsAre(HasSubstr("/window/background: \"grey\" is not a colour; give red")));
  EXPECT_THAT(with(R"("window": {"background": "#-60606"})"),
              ElementsAre(HasSubstr("is not a colour")));
}

TEST_F(Reading, JudgesTheAvOffset) {
  EXPECT_THAT(with(R"("intervals": {"av_offset_ms": 200})"), IsEmpty());
  EXPECT_THAT(
      with(R"("intervals": {"av_offset_ms": -201})"),
      ElementsAre(HasSubstr("/intervals/av_offset_ms: warning: sound and face are 201 ms")));
  EXPECT_THAT(with(R"("intervals": {"av_offset_ms": 1001})"),
              ElementsAre(HasSubstr("1001 is outside -1000 to 1000")));
}

TEST_F(Reading, WarnsOfWhatIsAllowedButProbablyNotMeant) {
  EXPECT_THAT(messages("\"Dog\"", "\"dog\", \"fish\""),
              ElementsAre(HasSubstr("/words: warning: 3 words do not divide by 2 conditions")));
  EXPECT_THAT(messages(", \"Dog\"", ""),
              ElementsAre(HasSubstr("/words: warning: 1 words for 2 conditions")));
  EXPECT_THAT(
      with(R"("practice": {"words": ["cat", "fish"]})"),
      ElementsAre(HasSubstr("/practice/words: warning: the practice word \"cat\" is also")));
  EXPECT_THAT(with(R"("practice": {"words": ["fish"]})"),
              ElementsAre(HasSubstr("/practice/words: warning: 1 practice words for 2")));
  EXPECT_THAT(with(R"("response": {"time_limit_s": 1})"),
              ElementsAre(HasSubstr("warning: few people can type")));
  EXPECT_THAT(with(R"("breaks": {"every_trials": 2, "text": "x"})"),
              ElementsAre(HasSubstr("warning: there are only 2 trials")));
  EXPECT_THAT(with(R"("breaks": {"every_trials": 1})"),
              ElementsAre(HasSubstr("/breaks: warning: breaks without a text")));
  EXPECT_THAT(messages(R"(["cat", "Dog"])", R"("monosyllables-414")"),
              ElementsAre("test.json:1: warning: 414 trials without a break; people tire: add "
                          "\"breaks\": { \"every_trials\": 100, \"text\": ... }"));
}

TEST_F(Reading, RefusesAnAnswerThatCannotHoldTheWord) {
  EXPECT_THAT(
      with(R"("response": {"longest": 2})"),
      ElementsAre(HasSubstr("/response/longest: 2 characters are too few to type \"cat\"")));
}

TEST_F(Reading, RefusesControlCharactersInTexts) {
  EXPECT_THAT(messages("\"Test\"", "\"T\\u0000\""),
              ElementsAre(HasSubstr("/title: \"T\\u0000\" contains a control character")));
  EXPECT_THAT(messages("\"Test\"", "\"T\\n\""), ElementsAre(HasSubstr("a line break")));
  EXPECT_THAT(messages("\"Test\"", "\" T\""),
              ElementsAre(HasSubstr("begins or ends with a blank")));
  EXPECT_THAT(with(R"("farewell": "a\u001b[2J")"), ElementsAre(HasSubstr("control character")));
  EXPECT_THAT(with(R"("farewell": "a\n\tb ")"), IsEmpty());
}

TEST_F(Reading, KeepsStrangeKeysOutOfItsMessages) {
  const auto all = with(R"("\u001b[2J": 1, ")" + std::string(100'000, 'k') + R"(": 2)");
  ASSERT_EQ(all.size(), 2U);
  for (const auto& message : all) {
    EXPECT_LT(message.size(), 600U);
    EXPECT_EQ(message.find('\x1b'), std::string::npos);
  }
}

TEST_F(Reading, CountsCharactersNotBytes) {
  std::string name;
  for (int i = 0; i < 40; ++i) name += "\xC3\xA9";
  EXPECT_THAT(messages("\"v\"", "\"" + name + "\""), IsEmpty());
  EXPECT_THAT(messages("\"v\"", "\"" + name + "x\""),
              ElementsAre(HasSubstr("41 characters are outside 1 to 40")));
}

}  // namespace
}  // namespace bimodal::protocols
