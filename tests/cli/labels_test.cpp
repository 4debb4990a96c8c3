// Labels are shown and converted.

#include "tests/cli/command_line.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class LabelsVerb : public CommandLine {
 protected:
  LabelsVerb() {
    files_.write("grid.align", "0 23750 sil\n23750 29500 bin\n");
    files_.write("two.csv",
                 "tier,start_s,end_s,text\nwords,0,1,butter\nphones,0,0.25,bcl\nphones,0.25,0.5,b\n"
                 "phones,0.5,1,axr\n");
    files_.write("bad.csv", "tier,start_s,end_s,text\nphones,0,0.25,K\nphones,0.25,0.5,cat\n");
  }
};

TEST_F(LabelsVerb, ShowsTheTiersOfAFile) {
  EXPECT_THAT(bimodal({"labels", "grid.align"}),
              ended(ExitCode::Done,
                    AllOf(HasSubstr("grid.align: 1.180 s, 1 tier\n"),
                          HasSubstr("words"),
                          HasSubstr("0.950-1.180 s \"bin\""))));
  EXPECT_THAT(bimodal({"labels", "two.csv"}),
              ended(ExitCode::Done, HasSubstr("every label of \"phones\" is a known phone")));
}

TEST_F(LabelsVerb, ShowsEveryLabelThatIsNoPhone) {
  EXPECT_THAT(bimodal({"labels", "bad.csv"}),
              ended(ExitCode::Findings,
                    AllOf(HasSubstr("1 label of \"phones\" is not known"),
                          HasSubstr("0.250-0.500 s \"cat\""))));
  EXPECT_THAT(bimodal({"labels", "grid.align", "--tier", "words", "--phones"}),
              ended(ExitCode::Findings, HasSubstr("1 label of \"words\" is not known")));
}

TEST_F(LabelsVerb, ConvertsBetweenFormats) {
  EXPECT_THAT(bimodal({"labels", "grid.align", "-o", "grid.TextGrid"}),
              ended(ExitCode::Done, HasSubstr("grid.TextGrid: 1.180 s, 1 tier")));
  EXPECT_THAT(bimodal({"labels", "grid.TextGrid", "-o", "again.align"}),
              ended(ExitCode::Done, HasSubstr("again.align")));
  EXPECT_EQ(bytes("again.align"), bytes("grid.align"));
}

TEST_F(LabelsVerb, WritesPhonesInArpabet) {
  EXPECT_THAT(bimodal({"labels", "two.csv", "--phones", "-o", "two.lab"}),
              ended(ExitCode::Done, HasSubstr("two.lab")));
  EXPECT_EQ(bytes("two.lab"), "0 5000000 B\n5000000 10000000 ER\n");
}

TEST_F(LabelsVerb, DropsNoTierUnasked) {
  EXPECT_THAT(bimodal({"labels", "two.csv", "-o", "two.lab"}),
              ended(ExitCode::InvalidInput,
                    AllOf(HasSubstr("\"words\", \"phones\""), HasSubstr("--tier"))));
  EXPECT_FALSE(std::filesystem::exists(path("two.lab")));
  EXPECT_THAT(bimodal({"labels", "two.csv", "--tier", "words", "-o", "two.lab"}),
              ended(ExitCode::Done, HasSubstr("two.lab")));
  EXPECT_EQ(bytes("two.lab"), "0 10000000 butter\n");
}

TEST_F(LabelsVerb, RefusesWhatIsNotThere) {
  EXPECT_THAT(bimodal({"labels", "two.csv", "--tier", "tones"}),
              ended(ExitCode::InvalidInput,
                    AllOf(HasSubstr("no tier \"tones\""), HasSubstr("\"words\", \"phones\""))));
  EXPECT_THAT(bimodal({"labels", "grid.align", "--phones"}),
              ended(ExitCode::InvalidInput, HasSubstr("--tier")));
  EXPECT_THAT(bimodal({"labels", "absent.lab"}),
              ended(ExitCode::InvalidInput, HasSubstr("absent.lab")));
  EXPECT_THAT(bimodal({"labels", "bad.csv", "--phones", "-o", "bad.lab"}),
              ended(ExitCode::InvalidInput, HasSubstr("\"cat\" at 0.25 s is no phone")));
  EXPECT_THAT(bimodal({"labels", "grid.align", "-o", "grid.txt"}),
              ended(ExitCode::InvalidInput, HasSubstr("grid.txt")));
  EXPECT_THAT(bimodal({"labels"}), ended(ExitCode::Usage, HasSubstr("--help")));
}

}  // namespace
}  // namespace bimodal
