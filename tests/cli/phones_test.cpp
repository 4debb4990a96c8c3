// Text and transcriptions become phones, one a line.

#include "tests/cli/command_line.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::Eq;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class PhonesVerb : public CommandLine {
 protected:
  [[nodiscard]] Ended phones(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "phones");
    return bimodal(arguments);
  }
};

TEST_F(PhonesVerb, PrintsOnePhoneALine) {
  EXPECT_THAT(phones({"stew"}), ended(ExitCode::Done, Eq("S\nT\nUW\n")));
  EXPECT_THAT(phones({"I", "buy", "now"}), ended(ExitCode::Done, Eq("AY\nB\nAY\nN\nAW\n")));
  EXPECT_THAT(phones({"boy"}), ended(ExitCode::Done, Eq("B\nOY\n")));
}

TEST_F(PhonesVerb, PrintsRestWhereWordsHaveAPauseBetweenThem) {
  EXPECT_THAT(phones({"Stew, boot."}), ended(ExitCode::Done, Eq("S\nT\nUW\nrest\nB\nUW\nT\n")));
  EXPECT_THAT(phones({"--method", "nrl", "Stew. Boot?"}),
              ended(ExitCode::Done, Eq("S\nT\nUW\nrest\nB\nUW\nT\n")));
}

TEST_F(PhonesVerb, SaysWhereDurationsAndAmbiguousSoundsBelong) {
  for (const auto* const text : {"S:140 UW", "b~w:3/8 AA"}) {
    EXPECT_THAT(phones({"--from", "arpabet", text}),
                ended(ExitCode::InvalidInput, HasSubstr("bimodal tracks --from arpabet")));
  }
}

TEST_F(PhonesVerb, ReadsByRuleOrDictionary) {
  EXPECT_THAT(phones({"--method", "nrl", "HELLO WORLD"}),
              ended(ExitCode::Done, Eq("HH\nEH\nL\nOW\nW\nER\nL\nD\n")));
  EXPECT_THAT(phones({"--method", "nrl", "22"}), ended(ExitCode::Done, Eq("T\nUW\nT\nUW\n")));
  EXPECT_THAT(phones({"22"}), ended(ExitCode::Done, Eq("T\nW\nEH\nN\nT\nIY\nT\nUW\n")));
  EXPECT_THAT(phones({"read(2)"}), ended(ExitCode::Done, Eq("R\nIY\nD\n")));
}

TEST_F(PhonesVerb, TellsWhichWordsTheDictionaryLacks) {
  EXPECT_THAT(phones({"zorb"}),
              ended(ExitCode::Done,
                    AllOf(HasSubstr("\"zorb\" is not in the dictionary"),
                          HasSubstr("letter-to-sound rules: Z AO R B\n"),
                          HasSubstr("\nZ\nAO\nR\nB\n"))));
}

TEST_F(PhonesVerb, TellsEveryPronunciationInTheDictionarysFormat) {
  EXPECT_THAT(phones({"--variants", "read stew"}),
              ended(ExitCode::Done, Eq("read R EH D\nread(2) R IY D\nstew S T UW\n")));
  EXPECT_THAT(phones({"--variants", "--show", "ipa", "read"}),
              ended(ExitCode::Done, Eq("read ɹɛd\nread(2) ɹid\n")));
  EXPECT_THAT(phones({"--variants", "--method", "nrl", "read"}),
              ended(ExitCode::InvalidInput, HasSubstr("--variants")));
}

TEST_F(PhonesVerb, ReadsAndShowsIpaAndXSampa) {
  EXPECT_THAT(phones({"--show", "ipa", "chair, stew"}),
              ended(ExitCode::Done, Eq("t͡ʃ\nɛ\nɹ\nrest\ns\nt\nu\n")));
  EXPECT_THAT(phones({"--from", "ipa", "stuː"}), ended(ExitCode::Done, Eq("S\nT\nUW\n")));
  EXPECT_THAT(phones({"--from", "xsampa", "--show", "ipa", "tS3`tS"}),
              ended(ExitCode::Done, Eq("t͡ʃ\nɝ\nt͡ʃ\n")));
  EXPECT_THAT(phones({"--from", "arpabet", "--show", "xsampa", "s t uw1"}),
              ended(ExitCode::Done, Eq("s\nt\nu\n")));
  EXPECT_THAT(phones({"--from", "ipa", "--method", "nrl", "stu"}),
              ended(ExitCode::InvalidInput, HasSubstr("leave --method")));
  EXPECT_THAT(phones({"--from", "ipa", "bet"}),
              ended(ExitCode::InvalidInput, HasSubstr("near it is eɪ (EY)")));
}

TEST_F(PhonesVerb, LetsFestivalRead) {
  EXPECT_THAT(phones({"--method", "festival", "stew"}), ended(ExitCode::Done, Eq("S\nT\nUW\n")));
  EXPECT_THAT(phones({"--method", "festival", "don\u2019t"}),
              ended(ExitCode::Done, Eq("D\nOW\nN\nT\n")));
}

TEST_F(PhonesVerb, RefusesWhatCannotBeSaid) {
  for (const std::string method : {"dictionary", "nrl", "festival"}) {
    for (const std::string text : {"", "!?"}) {
      EXPECT_THAT(phones({"--method", method, text}),
                  ended(ExitCode::InvalidInput,
                        AllOf(StartsWith("bimodal: "), HasSubstr("there are no words"))));
    }
  }
  EXPECT_THAT(phones({"50%"}), ended(ExitCode::InvalidInput, HasSubstr("\"%\"")));
  EXPECT_THAT(phones({}), ended(ExitCode::Usage, HasSubstr("--help")));
  EXPECT_THAT(phones({"--method", "flite", "stew"}), ended(ExitCode::Usage, HasSubstr("--help")));
}

}  // namespace
}  // namespace bimodal
