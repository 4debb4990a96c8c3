#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/analysis/cli/program_run.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::analysis {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class ProportionsVerb : public testing::Test {
 protected:
  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    return files_.write(name, text).string();
  }

  WrittenFiles files_;
};

// scipy: stats.norm.ppf((9 + .5) / 11) - stats.norm.ppf((2 + .5) / 11)
TEST_F(ProportionsVerb, GivesSensitivityOfYesAndNo) {
  const auto counts =
      file("y.csv", "who,hits,signals,false_alarms,noises\nNA,9,10,2,10\nx,1,1,0,0\n");
  const auto read = json::parse(run({"proportions", counts, "--json"}).out);
  EXPECT_EQ(read["rows"][0]["labels"]["who"], "NA");
  EXPECT_NEAR(read["rows"][0]["d_prime"], 1.8446621568568156, 1e-12);
  EXPECT_TRUE(read["rows"][1]["d_prime"].is_null());
  EXPECT_THAT(run({"proportions", counts}).out, HasSubstr("there is no d'"));
}

// scipy: the d' at which the integral of norm.pdf(x - d) norm.cdf(x)^3 is 3.25 / 11
TEST_F(ProportionsVerb, GivesSensitivityOfChoices) {
  const auto counts = file("k.csv", "c,k,n\nv,3,10\n");
  const auto read = json::parse(run({"proportions", counts, "--alternatives", "4", "--json"}).out);
  EXPECT_NEAR(read["rows"][0]["d_prime"], 0.16928948501193397, 1e-9);
  EXPECT_THAT(run({"proportions", counts, "--alternatives", "4", "--csv"}).out,
              HasSubstr("\"d_prime\"\n"));
}

TEST_F(ProportionsVerb, EstimatesTrialsByParticipantToo) {
  const auto trials = file("t.csv",
                           "participant,condition,stimulus,response\nP1,v,bat,bat\nP1,v,pat,bat\n"
                           "P2,v,bat,\nP2,v,pat,pat\n");
  const auto lexicon = file("l.csv", "word,phonemes\nbat,B AE T\npat,P AE T\n");
  const auto read = json::parse(
      run({"proportions", trials, "--lexicon", lexicon, "--by-participant", "--json"}).out);
  const auto& pooled = read["proportions"][0];
  EXPECT_EQ(pooled["measure"], "word");
  EXPECT_EQ(pooled["correct"], 2);
  EXPECT_EQ(pooled["judged"], 4);
  EXPECT_TRUE(pooled["participant"].is_null());
  EXPECT_EQ(read["data"]["analysed_trials"], 4);
  const auto text = run({"proportions", trials, "--lexicon", lexicon, "--by-participant"});
  EXPECT_THAT(text.out, AllOf(HasSubstr("(all)"), HasSubstr("P2"), HasSubstr("Wilson")));
}

}  // namespace
}  // namespace bimodal::analysis
