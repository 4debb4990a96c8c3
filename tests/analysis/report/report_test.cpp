#include <algorithm>
#include <cstdlib>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "analysis/report/columns.hpp"
#include "analysis/report/csv.hpp"
#include "analysis/report/figure_files.hpp"
#include "analysis/report/matrix_text.hpp"
#include "analysis/report/page.hpp"
#include "analysis/report/place_class.hpp"
#include "analysis/report/printed_number.hpp"
#include "analysis/report/tables.hpp"
#include "stimuli/base/markup.hpp"
#include "tests/analysis/examples.hpp"

namespace bimodal::analysis {
namespace {

using examples::session;
using examples::stored_trial;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

runner::StoredTrial visual(runner::StoredTrial trial) {
  trial.plan.condition = "visual & <only>";
  trial.plan.auditory_talker.reset();
  trial.plan.snr_db.reset();
  trial.plan.visual_talker = "face";
  return trial;
}

/// Two participants, three words in each of two conditions, answered by hand.
Results example_results() {
  const WrittenFiles folder;
  auto one = session("P01",
                     {stored_trial(0, "bat", "B AE T", "bat"),
                      stored_trial(1, "two", "T UW", "too"),
                      stored_trial(2, "stew", "S T UW", "bee"),
                      visual(stored_trial(3, "bat", "B AE T", "pat")),
                      visual(stored_trial(4, "two", "T UW", "")),
                      visual(stored_trial(5, "stew", "S T UW", "stoo, \"I\" think"))});
  auto other = session("P02",
                       {stored_trial(0, "bat", "B AE T", "mat"),
                        stored_trial(1, "two", "T UW", "two"),
                        visual(stored_trial(2, "bat", "B AE T", "mat")),
                        visual(stored_trial(3, "stew", "S T UW", "two"))});
  other.session.participant_number = 2;
  other.session.simulated_answers = true;
  other.session.observer = "listener";
  const std::vector files{examples::file("day \"1\".sqlite", {one, other})};
  return analyse(gather_trials(files),
                 examples::dictionary(folder),
                 {.file = "words.dict", .sha256 = "feed"},
                 {.bootstrap = {.draws = 200, .seed = 1}, .progress = [](std::string_view) {}});
}

const Proportion& pooled(const Results& results, std::size_t condition, Measure measure) {
  return results.pooled.at(condition * kMeasures.size() + static_cast<std::size_t>(measure));
}

TEST(Analyse, CountsAsByHand) {
  const auto results = example_results();
  ASSERT_EQ(results.conditions.size(), 2U);
  const auto& heard = results.conditions[0];
  EXPECT_EQ(heard.name, "auditory");
  EXPECT_EQ(heard.meaning, "heard festival:kal at \u22128 dB S/N");
  EXPECT_EQ(heard.correct, 2);
  EXPECT_EQ(heard.homophones, 1);
  EXPECT_EQ(heard.wrong, 2);
  const auto& seen = results.conditions[1];
  EXPECT_EQ(seen.wrong, 3);
  EXPECT_EQ(seen.unknown, 1);
  EXPECT_EQ(seen.omissions, 1);
  EXPECT_THAT(results.participants, ElementsAre("P01", "P02"));

  EXPECT_EQ(pooled(results, 0, Measure::Word).proportion, 0.6);
  // bat 3/3, two 2/2, stew/bee 0/3, bat/mat 2/3, two 2/2
  EXPECT_EQ(pooled(results, 0, Measure::Phoneme).correct, 9);
  EXPECT_EQ(pooled(results, 0, Measure::Phoneme).judged, 13);
  // bat/pat 2/3, two/blank 0/2, bat/mat 2/3, stew/two 2/3; the unknown answer is left out
  EXPECT_EQ(pooled(results, 1, Measure::Phoneme).correct, 6);
  EXPECT_EQ(pooled(results, 1, Measure::Phoneme).judged, 11);
  // stew/bee: S or T became B, so this initial consonant is not judged
  EXPECT_EQ(pooled(results, 0, Measure::ConsonantInitial).judged, 4);
}

TEST(Analyse, TabulatesConfusionsAsByHand) {
  const auto results = example_results();
  const auto& heard = results.confusions.at(0);
  EXPECT_EQ(heard.unit, Unit::ConsonantInitial);
  EXPECT_EQ(heard.ambiguous, 1);
  const auto& seen = results.confusions.at(1);
  EXPECT_EQ(matrix_csv(seen.matrix),
            "\"stimulus\",\"P\",\"B\",\"M\",\"T\",\"S\",\"deleted\",\"blank\",\"other\"\n"
            "\"B\",1,0,1,0,0,0,0,0\n"
            "\"T\",0,0,0,0,0,0,1,0\n"
            "\"S\",0,0,0,0,0,1,0,1\n");
  const auto& final_consonants = results.confusions.at(5);
  EXPECT_EQ(final_consonants.lacking, 3);
}

TEST(Analyse, NamesTheMethodOfEveryInterval) {
  const auto results = example_results();
  for (const auto& proportion : results.pooled) {
    EXPECT_EQ(proportion.interval.has_value(), proportion.method.starts_with("crossed bootstrap"))
        << proportion.method;
  }
  EXPECT_EQ(pooled(results, 1, Measure::Word).method,
            "no interval: without any variation resampling says nothing");
  for (const auto& proportion : results.individual) {
    if (proportion.measure != Measure::Word) continue;
    EXPECT_EQ(proportion.method, "Wilson");
    EXPECT_EQ(proportion.interval, wilson(proportion.correct, proportion.judged));
  }
}

TEST(ReportPage, TellsOfEverySessionHowFinelyTheFaceWasDrawnAndWhy) {
  auto results = example_results();
  results.dataset.sessions.at(0).face_quality = "full";
  results.dataset.sessions[0].face_quality_basis = "measured";
  const auto page =
      report_page(results, {}, {.program = "test", .made_utc = "now", .selection = "all"});
  EXPECT_THAT(page, HasSubstr("<th scope='col'>Face drawn</th>"));
  EXPECT_THAT(page, HasSubstr("<td>full (measured)</td>"));
  EXPECT_THAT(page, HasSubstr("<td>&#8211;</td>"));  // the other session showed none
}

TEST(ReportPage, IsWholeWithoutAnythingElse) {
  const auto results = example_results();
  const std::vector<Attachment> attachments{{.kind = Attachment::Kind::Picture,
                                             .media_type = "image/png",
                                             .caption = "trial \"1\"",
                                             .bytes = "abc"}};
  const auto page =
      report_page(results, attachments, {.program = "test", .made_utc = "now", .selection = "all"});
  EXPECT_THAT(page, HasSubstr("SIMULATED"));
  EXPECT_THAT(page, HasSubstr("1 of 2 sessions was simulated (observer: listener)"));
  EXPECT_THAT(page, HasSubstr("visual &amp; &lt;only&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<only>")));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,YWJj"));
  EXPECT_THAT(page, HasSubstr("day &quot;1&quot;.sqlite"));
  for (const auto* const fetched : {"http:", "https:", "<script src", "<link", "@import", "url("}) {
    EXPECT_THAT(page, Not(HasSubstr(fetched)));
  }
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(page, '\0')), 0U);
  EXPECT_THAT(page, HasSubstr("aria-label='Confusion matrix: Vowels, condition auditory. 2 "));
  std::size_t matrices = 0;
  for (auto at = page.find("<title>Confusion matrix"); at != std::string::npos;
       at = page.find("<title>Confusion matrix", at + 1)) {
    ++matrices;
  }
  EXPECT_EQ(matrices, kPlaceUnits.size() * results.conditions.size());
}

/// Every element that is opened is closed, in order: a small judge of well-formedness.
std::string first_unbalanced(std::string_view page) {
  std::vector<std::string> open;
  for (auto at = page.find('<'); at != std::string_view::npos; at = page.find('<', at + 1)) {
    const auto end = page.find('>', at);
    if (end == std::string_view::npos) return "unfinished tag";
    const auto tag = page.substr(at + 1, end - at - 1);
    if (tag.starts_with('!') || tag.ends_with('/')) continue;
    const auto name = std::string{tag.substr(0, tag.find_first_of(" \n"))};
    if (!name.starts_with('/')) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name.substr(1)) {
      return name;
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back();
}

TEST(ReportPage, ClosesEveryElement) {
  EXPECT_EQ(first_unbalanced("<a><b></a>"), "/a");
  const auto page = report_page(example_results(), {}, {});
  EXPECT_EQ(first_unbalanced(page), "");
}

TEST(ReportPage, ShowsWhichPhonesAreAlikeWhereThreeWerePresented) {
  const auto page = report_page(example_results(), {}, {});
  // Initial B, T and S; of those heard S is ambiguous. Two vowels, one final consonant.
  EXPECT_THAT(page, HasSubstr("<title>Dendrogram: Initial consonants, condition visual &amp; "));
  EXPECT_THAT(page, Not(HasSubstr("<title>Dendrogram: Initial consonants, condition auditory")));
  EXPECT_THAT(page,
              HasSubstr("<title>Layout: Initial consonants, condition visual &amp; &lt;only"));
  EXPECT_THAT(page, Not(HasSubstr("<title>Layout: Vowels")));
  EXPECT_THAT(page, HasSubstr("<b>Figure 10. Initial consonants, condition visual"));
}

TEST(FigureFiles, AreSvgAndPdfInBothWidthsUnderPlainNames) {
  const auto files = figure_files(example_results(), {.made_utc = "2026-11-22T10:00:00Z"});
  std::vector<std::string> names;
  for (const auto& file : files) {
    names.push_back(file.name);
    const bool is_pdf = file.name.ends_with(".pdf");
    EXPECT_TRUE(file.content.starts_with(is_pdf ? "%PDF" : "<svg xmlns=")) << file.name;
  }
  // Words, features of initial and final consonants, six matrices, a dendrogram and a layout.
  EXPECT_EQ(names.size(), 11U * 4U);
  EXPECT_THAT(names,
              testing::Contains("figures/consonant-initial-visual____only_-layout-85mm.pdf"));
  EXPECT_THAT(names, testing::Contains("figures/words-174mm.svg"));
}

TEST(ReportTables, HaveARowForEveryTrialAndSayWhatColumnsMean) {
  const auto results = example_results();
  const auto files = report_tables(results, {});
  std::vector<std::string> names;
  for (const auto& file : files) names.push_back(file.name);
  EXPECT_THAT(names,
              ElementsAre("trials.csv",
                          "words.csv",
                          "proportions.csv",
                          "benefits.csv",
                          "confusions.csv",
                          "likeness.csv",
                          "exclusions.csv",
                          "columns.csv",
                          "manifest.json"));
  EXPECT_EQ(std::ranges::count(files[0].content, '\n'), 11);
  EXPECT_THAT(files[0].content,
              HasSubstr("\"stew\",,,\"S T UW\",\"stoo, \"\"I\"\" think\",\"stooithink\",\"not in "
                        "dictionary\",0,3,,\"other\",\"other\",,500,1000,0,0,0\n"));
  EXPECT_THAT(files[4].content,
              HasSubstr("\"auditory\",\"consonant-initial\",\"B\",\"M\",1,2,0.5\n"));
}

/// Fields of one line; a comma within quotation marks is none.
std::size_t fields(std::string_view line) {
  std::size_t count = 1;
  bool quoted = false;
  for (const char letter : line) {
    if (letter == '"') quoted = !quoted;
    if (letter == ',' && !quoted) ++count;
  }
  return count;
}

TEST(ReportTables, HaveAsManyFieldsInEveryRowAsColumnsSay) {
  for (const auto& file : report_tables(example_results(), {})) {
    if (!file.name.ends_with(".csv")) continue;
    const auto table = file.name.substr(0, file.name.size() - 4);
    std::string_view rest = file.content;
    while (!rest.empty()) {
      const auto line = rest.substr(0, rest.find('\n'));
      EXPECT_EQ(fields(line), columns_of(table).size()) << file.name << ": " << line;
      rest.remove_prefix(line.size() + 1);
    }
  }
}

TEST(ReportTables, TellInTheManifestWhatWasAnalysed) {
  const auto files = report_tables(example_results(), {.program = "bimodal-analysis 0.1.0"});
  const auto manifest = nlohmann::json::parse(files.back().content);
  EXPECT_EQ(manifest["program"], "bimodal-analysis 0.1.0");
  EXPECT_EQ(manifest["data"][0]["sha256"], "sha of day \"1\".sqlite");
  EXPECT_EQ(manifest["bootstrap"]["draws"], 200);
  EXPECT_EQ(manifest["analysed_trials"], 10);
  EXPECT_EQ(manifest["simulated"], true);
}

TEST(Csv, QuotesTextAndNothingElse) {
  std::string table;
  const std::vector<CsvField> line{std::string_view{"NA"},
                                   std::string_view{"a,\"b\"\n"},
                                   std::string_view{""},
                                   CsvField{},
                                   std::int64_t{-3},
                                   0.25,
                                   1e-7};
  append_csv(table, line);
  EXPECT_EQ(table, "\"NA\",\"a,\"\"b\"\"\n\",\"\",,-3,0.25,1e-07\n");
}

TEST(MatrixText, AlignsProportionsAndSaysWhatIsLeftOut) {
  ConfusionMatrix matrix{{"B", "NA"}, {"B", "NA", "V", "blank"}};
  for (int i = 0; i < 3; ++i) matrix.add("B", "B");
  matrix.add("B", "blank");
  EXPECT_EQ(matrix_text("Initial consonants, condition visual", matrix) +
                left_out_text({.unit = Unit::ConsonantInitial,
                               .condition = "visual",
                               .matrix = matrix,
                               .ambiguous = 2,
                               .lacking = 1}),
            "Initial consonants, condition visual: row proportions (rows: stimuli, columns: "
            "responses)\n\n"
            "            B blank       n\n"
            "       B  .75   .25       4\n"
            "      NA                  0\n\n"
            "Correct: 3 of 4 (75.0 %).\n"
            "Not in the table: ambiguous alignments 2, words without this unit 1.\n");
}

// 3/40, 23/40 and 1/16 of 1 are halves between printed numbers; the first two are a hair less in
// binary, and the third is exact, which printf rounds to the even digit.
TEST(PrintProportion, RoundsHalvesAwayFromZero) {
  EXPECT_EQ(print_proportion(3.0 / 40.0), ".08");
  EXPECT_EQ(print_proportion(23.0 / 40.0), ".58");
  EXPECT_EQ(print_proportion(1.0 / 40.0), ".03");
  EXPECT_EQ(print_proportion(27.0 / 40.0 - 24.0 / 40.0), ".08");
  EXPECT_EQ(print_decimals(-3.0 / 40.0), "-.08");
  EXPECT_EQ(print_proportion(0.0749999), ".07");
  EXPECT_EQ(print_percent(1.0 / 16.0), "6.3");
  EXPECT_EQ(print_rounded(-0.004, 2), "0.00");
  EXPECT_EQ(print_decimals(-0.004), ".00");
  EXPECT_EQ(print_decimals(-12.345), "-12.35");
  for (int n = 1; n <= 200; ++n) {
    for (int k = 0; k <= n; ++k) {
      const int hundredths = (200 * k + n) / (2 * n);  // the nearest, halves up, in whole numbers
      EXPECT_EQ(print_rounded(static_cast<double>(k) / n, 2),
                std::to_string(hundredths / 100) + (hundredths % 100 < 10 ? ".0" : ".") +
                    std::to_string(hundredths % 100))
          << k << " of " << n;
    }
  }
}

TEST(PrintProportion, HasNoLeadingZero) {
  EXPECT_EQ(print_proportion(0.0), ".00");
  EXPECT_EQ(print_proportion(0.074), ".07");
  EXPECT_EQ(print_proportion(0.996), "1.00");
  EXPECT_EQ(print_proportion(1.0), "1.00");
}

TEST(PlaceClass, FollowsTheOrderOfThePhones) {
  EXPECT_EQ(place_class("M"), "bilabial");
  EXPECT_EQ(place_class("WH"), "labio-velar");
  EXPECT_EQ(place_class("R"), "alveolar");
  EXPECT_EQ(place_class("NG"), "velar");
  EXPECT_EQ(place_class("IY"), "front");
  EXPECT_EQ(place_class("AY"), "diphthong");
  EXPECT_EQ(place_class("blank"), "no phone");
}

TEST(Base64, AgreesWithTheStandardsExamples) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace bimodal::analysis
