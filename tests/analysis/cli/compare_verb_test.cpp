#include <array>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/random.hpp"
#include "tests/analysis/cli/program_run.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::analysis {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kNatural =
    "stimulus,p,b,m,f,v,blank\np,20,10,8,1,0,1\nb,9,18,11,1,1,0\nm,7,9,22,1,0,1\nf,0,1,0,30,8,1\n"
    "v,1,0,1,10,27,1\n";
constexpr const char* kSynthetic =
    "stimulus,p,b,m,v,f,blank\np,15,12,8,0,5,0\nb,9,14,11,4,2,0\nm,7,9,19,3,2,0\nf,5,4,3,10,15,3\n"
    "v,6,5,4,15,8,2\n";

/// Eight participants, forty words of four kinds in two conditions; the natural face shows what
/// begins with F, with the synthetic one it is taken for P as often as not.
std::string trials_of_two_faces() {
  const std::array<std::string, 4> words{"pat", "fat", "bat", "mat"};
  Random random{5};
  std::string table = "participant,trial,condition,stimulus,response\n";
  for (int participant = 1; participant <= 8; ++participant) {
    int trial = 0;
    for (int item = 0; item < 40; ++item) {
      const auto& word = words.at(static_cast<std::size_t>(item % 4));
      const auto presented = word + std::to_string(item);
      for (const std::string condition : {"nat", "syn"}) {
        const bool lost = word == "fat" && condition == "syn" && random.below(2) == 0;
        const auto& wrong = words.at(random.below(2) == 0 ? 0 : 2);
        const auto& answer = lost ? words[0] : random.below(4) == 0 && word != "fat" ? wrong : word;
        table +=
            fmt::format("P{},{},{},{},{}\n", participant, ++trial, condition, presented, answer);
      }
    }
  }
  return table;
}

std::string lexicon() {
  std::string table = "word,phonemes\npat,P AE T\nfat,F AE T\nbat,B AE T\nmat,M AE T\n";
  const std::array<std::string, 4> words{"pat,P", "fat,F", "bat,B", "mat,M"};
  for (int item = 0; item < 40; ++item) {
    const auto& word = words.at(static_cast<std::size_t>(item % 4));
    table += fmt::format("{}{}{} AE T\n", word.substr(0, 3), item, word.substr(3));
  }
  return table;
}

class CompareVerb : public testing::Test {
 protected:
  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    return files_.write(name, text).string();
  }

  [[nodiscard]] ProgramRun compare_trials(std::vector<std::string> more) const {
    std::vector<std::string> arguments{"compare",
                                       file("t.csv", trials_of_two_faces()),
                                       "--lexicon",
                                       file("l.csv", lexicon()),
                                       "--resamples",
                                       "999"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  WrittenFiles files_;
};

// scipy 1.10.1: numpy.corrcoef, stats.spearmanr, spatial.distance.jensenshannon squared,
// stats.chi2_contingency(correction=False), with the columns of the second put in the order of the
// first and those without responses left out.
TEST_F(CompareVerb, AgreesWithScipyAboutTwoMatrices) {
  const auto made = run({"compare", file("n.csv", kNatural), file("s.csv", kSynthetic), "--json"});
  ASSERT_EQ(made.code, ExitCode::Done) << made.err;
  const auto read = json::parse(made.out);
  EXPECT_NEAR(read["all_cells"]["pearson"], 0.9091559156813278, 1e-12);
  EXPECT_NEAR(read["all_cells"]["spearman"], 0.8393637110304929, 1e-12);
  EXPECT_NEAR(read["all_cells"]["rmsd"], 0.10954451150103323, 1e-12);
  EXPECT_NEAR(read["off_diagonal_cells"]["pearson"], 0.870022712422107, 1e-12);
  EXPECT_NEAR(read["off_diagonal_cells"]["spearman"], 0.7199587628455351, 1e-12);
  EXPECT_NEAR(read["off_diagonal_cells"]["rmsd"], 0.06264982043070834, 1e-12);
  EXPECT_NEAR(read["rows"][3]["jsd_bits"], 0.1747820677273328, 1e-12);
  EXPECT_NEAR(read["rows"][3]["chi_square"], 16.022222222222222, 1e-12);
  EXPECT_EQ(read["rows"][3]["df"], 5);
  EXPECT_NEAR(read["chi_square"], 42.12672720233696, 1e-11);
  EXPECT_NEAR(read["accuracy_ratio"], 0.39 / 0.585, 1e-12);
  EXPECT_EQ(read["permutation"]["randomisation"], "responses");
  EXPECT_LT(read["permutation"]["p"], 0.02);
  EXPECT_EQ(read["data"]["files"].size(), 2U);
  EXPECT_EQ(read["data"]["resamples"], 10'000);
}

TEST_F(CompareVerb, FindsWhatTheSyntheticFaceFailsToShow) {
  const auto made = compare_trials({"--natural", "nat", "--synthetic", "syn", "--json"});
  ASSERT_EQ(made.code, ExitCode::Done) << made.err;
  const auto read = json::parse(made.out);
  EXPECT_EQ(read["permutation"]["randomisation"], "within-items");
  EXPECT_EQ(read["permutation"]["trials_used"], 640);
  EXPECT_LE(read["permutation"]["p"], 0.001);
  EXPECT_EQ(read["participants"], 8);
  EXPECT_EQ(read["noise_ceiling_all_cells"]["halves_of"], "participants");
  const auto& first = read["contrasts"][0];
  EXPECT_THAT(first["in_words"].get<std::string>(), AllOf(HasSubstr("P"), HasSubstr("F")));
  EXPECT_GT(first["loss"], 0.2);
  const auto text = compare_trials({"--natural", "nat", "--synthetic", "syn"});
  EXPECT_THAT(text.out,
              AllOf(HasSubstr("F answered P: .00 and"),
                    HasSubstr("Words correct, second less first"),
                    HasSubstr("What \"syn\" fails to show")));
}

TEST_F(CompareVerb, FindsNothingBetweenAFaceAndItself) {
  const auto matrix = file("n.csv", kNatural);
  const auto copy = file("c.csv", kNatural);
  const auto made = run({"compare", matrix, copy, "--json"});
  const auto read = json::parse(made.out);
  EXPECT_EQ(read["all_cells"]["pearson"], 1.0);
  EXPECT_EQ(read["permutation"]["p"], 1.0);
  EXPECT_EQ(read["chi_square"], 0.0);
  EXPECT_THAT(run({"compare", matrix, copy}).out,
              AllOf(HasSubstr("No single cell differs"), HasSubstr("shows every contrast")));
}

TEST_F(CompareVerb, PrintsEveryCellAsCsv) {
  const auto made = run({"compare", file("n.csv", kNatural), file("s.csv", kSynthetic), "--csv"});
  EXPECT_THAT(made.out,
              AllOf(HasSubstr("\"stimulus\",\"response\",\"count_1\""),
                    HasSubstr("\n\"f\",\"f\",30,15,0.75,0.375,0.375,")));
}

TEST_F(CompareVerb, SaysWhatIsMissing) {
  const auto matrix = file("n.csv", kNatural);
  EXPECT_THAT(run({"compare", matrix}).err, HasSubstr("one is given; name two"));
  EXPECT_THAT(run({"compare", matrix, matrix, "--natural", "a"}).err,
              HasSubstr("leave them out: of two matrices"));
  EXPECT_THAT(compare_trials({}).err, HasSubstr("which two? Name them with --natural"));
  EXPECT_THAT(compare_trials({"--natural", "nat", "--synthetic", "other"}).err,
              HasSubstr("no condition \"other\"; there are: nat, syn"));
}

TEST_F(CompareVerb, SaysWhyThereIsNoTest) {
  const auto trials = file("t.csv",
                           "participant,condition,stimulus,response\n1,a,pat,pat\n1,b,bat,pat\n"
                           "2,a,pat,bat\n2,b,bat,bat\n");
  const auto made = run({"compare",
                         trials,
                         "--lexicon",
                         file("l.csv", lexicon() + "bat,B AE T\n"),
                         "--natural",
                         "a",
                         "--synthetic",
                         "b"});
  EXPECT_THAT(made.out, AllOf(HasSubstr("No test: every word was met"), Not(HasSubstr("Pearson"))));
}

}  // namespace
}  // namespace bimodal::analysis
