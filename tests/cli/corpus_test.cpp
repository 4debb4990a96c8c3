#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/command_line.hpp"

namespace bimodal {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kManifest = R"({
  "bimodal_corpus": 1,
  "name": "small",
  "recordings": [
    {"file": "media/one.wav", "sha256": "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", "talker": "s1"}
  ],
  "items": [
    {"item": "blue", "word": "blue", "recording": "media/one.wav", "start_s": 1.0, "end_s": 1.5, "phones": "B L UW", "times_s": [1.1, 1.2, 1.25, 1.4]},
    {"item": "bin", "word": "bin", "recording": "media/one.wav", "start_s": 2.0, "end_s": 2.5, "phones": "B IH N", "times_s": [2.1, 2.2, 2.25, 2.4], "doubt": "sounds more like \"pin\""}
  ]
}
)";

class CorpusCommands : public CommandLine {
 protected:
  CorpusCommands() { files_.write("small/corpus.json", kManifest); }
};

TEST_F(CorpusCommands, ListTellsItemsWordsAndDoubts) {
  EXPECT_THAT(bimodal({"corpus", "list", "small"}),
              ended(ExitCode::Done, AllOf(HasSubstr("B L UW"), HasSubstr("sounds more like"))));
  EXPECT_THAT(bimodal({"corpus", "list", "small", "--words"}),
              ended(ExitCode::Done, testing::StrEq("blue\n")));
  EXPECT_THAT(bimodal({"corpus", "list", "small", "--csv"}),
              ended(ExitCode::Done,
                    HasSubstr("bin,bin,B IH N,media/one.wav,s1,2.000000,2.500000,\"sounds more "
                              "like \"\"pin\"\"\"\n")));
}

TEST_F(CorpusCommands, ListWritesAWordListThatAProtocolCanUse) {
  EXPECT_THAT(bimodal({"corpus", "list", "small", "--as-list", "words.json"}),
              ended(ExitCode::Done, HasSubstr("words.json: 1 word")));
  EXPECT_THAT(bytes("words.json"), HasSubstr(R"({"word": "blue", "phones": ["B", "L", "UW"]})"));
}

TEST_F(CorpusCommands, AcceptTakesDoubtsAway) {
  EXPECT_THAT(bimodal({"corpus", "accept", "small", "pin"}),
              ended(ExitCode::InvalidInput, HasSubstr("there is no item 'pin'")));
  EXPECT_THAT(bimodal({"corpus", "accept", "small"}),
              ended(ExitCode::InvalidInput, HasSubstr("--all")));
  EXPECT_THAT(bimodal({"corpus", "accept", "small", "bin"}),
              ended(ExitCode::Done, HasSubstr("bin: accepted although sounds more like")));
  EXPECT_THAT(bimodal({"corpus", "list", "small", "--words"}),
              ended(ExitCode::Done, testing::StrEq("blue\nbin\n")));
}

TEST_F(CorpusCommands, CheckTellsOfMissingMedia) {
  EXPECT_THAT(bimodal({"corpus", "check", "small"}),
              ended(ExitCode::InvalidInput, AllOf(HasSubstr("one.wav"), HasSubstr("error"))));
}

TEST_F(CorpusCommands, BuildNamesWhatItCannotUse) {
  files_.write("words.txt", "bin blue");
  EXPECT_THAT(bimodal({"corpus", "build", "none.wav", "--words", "nowhere", "-o", "made"}),
              ended(ExitCode::InvalidInput, HasSubstr("there is no word list 'nowhere'")));
  files_.write("empty.json", R"({"words": []})");
  EXPECT_THAT(bimodal({"corpus", "build", "none.wav", "--words", "empty.json", "-o", "made"}),
              ended(ExitCode::InvalidInput, HasSubstr("there are no words")));
  EXPECT_THAT(bimodal({"corpus", "build", "--words", "monosyllables-414", "-o", "made"}),
              ended(ExitCode::InvalidInput, HasSubstr("no recordings were named")));
  EXPECT_THAT(
      bimodal({"corpus", "build", "none.wav", "--words", "monosyllables-414", "-o", "made"}),
      ended(ExitCode::InvalidInput,
            AllOf(HasSubstr("none.wav"), HasSubstr("no recording could be used"))));
  EXPECT_THAT(bimodal({"corpus", "build", "none.wav", "-o", "made"}),
              ended(ExitCode::Usage, HasSubstr("--words")));
}

TEST_F(CorpusCommands, AreExplained) {
  for (const char* const verb : {"build", "check", "list", "sheet", "accept"}) {
    EXPECT_THAT(bimodal({"corpus", verb, "--help"}), ended(ExitCode::Done, HasSubstr("Example")));
  }
  EXPECT_THAT(bimodal({"corpus", "check", "nowhere"}),
              ended(ExitCode::InvalidInput, HasSubstr("there is no such file")));
}

}  // namespace
}  // namespace bimodal
