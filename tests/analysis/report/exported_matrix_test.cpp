#include "analysis/report/exported_matrix.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/data/matrix_file.hpp"
#include "analysis/report/printed_matrix.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/random.hpp"
#include "tests/support/fault_of.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::analysis {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::string_view kTitle = "Vowels, \"face\" alone";
constexpr std::array kWarnings{"SIMULATED sessions are among the data", "\"two\", 3: warning"};

ConfusionMatrix sample() {
  return {{"p", "b", "NA"}, {"b", "p", "blank"}, {3, 20, 1, 15, 5.5, 0, 0, 0, 0}};
}

ExportedMatrix exported(const ConfusionMatrix& matrix, LabelOrder order = LabelOrder::Given) {
  return {kTitle, {kWarnings.begin(), kWarnings.end()}, matrix, order};
}

/// The forms that are read back.
std::vector<std::string> forms_of(const ExportedMatrix& matrix) {
  return {matrix_table_csv(matrix, CellContent::Counts, true),
          matrix_list_csv(matrix, true),
          matrix_json(matrix),
          matrix_praat(matrix)};
}

void expect_same(const ConfusionMatrix& one, const ConfusionMatrix& other) {
  EXPECT_EQ(one.stimuli(), other.stimuli());
  ASSERT_EQ(one.responses(), other.responses());
  for (std::size_t i = 0; i < one.stimuli().size(); ++i) {
    for (std::size_t j = 0; j < one.responses().size(); ++j) {
      EXPECT_EQ(one.count(i, j), other.count(i, j));
    }
  }
}

std::vector<std::string> random_labels(Random& random) {
  constexpr std::array<std::string_view, 16> kParts{"NA",
                                                    ",",
                                                    "\"",
                                                    "''",
                                                    " ",
                                                    "#",
                                                    "# ",
                                                    "\xC9\x94",
                                                    "\xCA\x83",
                                                    "{",
                                                    "\\",
                                                    "!",
                                                    "1",
                                                    "<e>",
                                                    "row [1]: ",
                                                    "count"};
  std::vector<std::string> labels;
  const auto size = 1 + random.below(7);
  while (labels.size() < size) {
    std::string label;
    for (auto parts = 1 + random.below(3); parts > 0; --parts) {
      label += kParts[random.below(kParts.size())];
    }
    if (std::ranges::find(labels, label) == labels.end()) labels.push_back(label);
  }
  return labels;
}

/// Whole counts, thirds and sevenths as alignments share responses out, tiny and large ones; some
/// rows empty.
ConfusionMatrix random_matrix(Random& random) {
  auto stimuli = random_labels(random);
  auto responses = random_labels(random);
  std::vector<double> counts;
  for (std::size_t i = 0; i < stimuli.size(); ++i) {
    const bool empty = random.below(4) == 0;
    for (std::size_t j = 0; j < responses.size(); ++j) {
      const auto whole = static_cast<double>(random.below(30));
      constexpr std::array kDivisors{1.0, 3.0, 7.0, 1e7, 1e-6};
      counts.push_back(empty ? 0.0 : whole / kDivisors[random.below(kDivisors.size())]);
    }
  }
  return {std::move(stimuli), std::move(responses), std::move(counts)};
}

TEST(ExportedMatrix, ReadsBackIdenticalWhateverLabelsAndCounts) {
  Random random{21};
  for (int round = 0; round < 2'000; ++round) {
    const auto matrix = random_matrix(random);
    for (const auto& form : forms_of(exported(matrix))) {
      const auto read = parse_titled_matrix(form, "m");
      EXPECT_EQ(read.title, kTitle);
      EXPECT_THAT(read.warnings, ElementsAreArray(kWarnings));
      expect_same(read.matrix, matrix);
      if (testing::Test::HasFailure()) FAIL() << form;
    }
  }
}

TEST(ExportedMatrix, SaysWhatAReaderMustKnow) {
  EXPECT_THAT(matrix_table_csv(exported(sample()), CellContent::Counts, true),
              StartsWith("# title: Vowels, \"face\" alone\n"
                         "# orientation: rows are stimuli, columns are responses\n"
                         "# cells: counts\n# order: as given\n# n: 44.5; of each row: 24, 20.5, 0\n"
                         "# warning: SIMULATED sessions are among the data\n"
                         "# warning: \"two\", 3: warning\n"
                         "\"stimulus\",\"b\",\"p\",\"blank\"\n\"p\",3,20,1\n"));
  EXPECT_THAT(matrix_table_csv(exported(sample()), CellContent::Counts, false),
              StartsWith("\"stimulus\","));
  const auto json = nlohmann::json::parse(matrix_json(exported(sample())));
  EXPECT_EQ(json["orientation"], "rows are stimuli, columns are responses");
  EXPECT_EQ(json["n"], 44.5);
  EXPECT_EQ(json["row_totals"], nlohmann::json::parse("[24, 20.5, 0]"));
  EXPECT_EQ(json["row_proportions"][0][0], 3.0 / 24.0);
  EXPECT_TRUE(json["row_proportions"][2][0].is_null());
  EXPECT_EQ(ExportedMatrix(" a\nb\t", {}, sample(), LabelOrder::Given).title, "a b");
  EXPECT_EQ(ExportedMatrix("\xff.csv", {}, sample(), LabelOrder::Given).title, ".csv");
}

TEST(ExportedMatrix, SaysWhichTrialsWereCounted) {
  auto made = exported(sample());
  made.provenance = {.program = "p 1",
                     .stored_trials = 50,
                     .analysed_trials = 45,
                     .exclusions = {{"practice trial", 5}}};
  EXPECT_THAT(matrix_praat(made),
              HasSubstr("! data: Trials: 50 in the data, 45 analysed; left out: 5 x practice "
                        "trial.\n! warning"));
  EXPECT_THAT(matrix_markdown(made), HasSubstr("left out: 5 x practice trial. Warning"));
  EXPECT_EQ(nlohmann::json::parse(matrix_json(made))["data"]["analysed_trials"], 45);
  for (const auto& form : forms_of(made)) expect_same(parse_matrix(form, "m"), made.matrix);
}

TEST(ExportedMatrix, HasRowProportionsInATableOfTheirOwn) {
  const auto table = matrix_table_csv(exported(sample()), CellContent::RowProportions, true);
  EXPECT_THAT(table, AllOf(HasSubstr("# cells: row proportions\n"), HasSubstr("\n\"p\",0.125,")));
  EXPECT_THAT(table, HasSubstr("\n\"NA\",,,\n"));
  EXPECT_THAT(fault_of([&] { return parse_matrix(table, "m.csv"); }),
              HasSubstr("the cells are row proportions"));
}

TEST(ExportedMatrix, PutsPhonesInTheOrderOfTheirPlaces) {
  const ConfusionMatrix matrix{
      {"K", "AA", "x", "B", "IY"},
      {"blank", "T", "B", "K"},
      {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19}};
  const auto ordered = exported(matrix, LabelOrder::Place);
  EXPECT_THAT(ordered.matrix.stimuli(), ElementsAre("B", "K", "IY", "AA", "x"));
  EXPECT_THAT(ordered.matrix.responses(), ElementsAre("B", "T", "K", "blank"));
  EXPECT_EQ(ordered.matrix.count(0, 0), 14);
  EXPECT_EQ(ordered.matrix.count(4, 3), 8);
  EXPECT_THAT(matrix_praat(ordered), HasSubstr("! order: place of articulation, front to back"));
  const ConfusionMatrix strange{{"1", "2"}, {"1", "2"}, {1, 2, 3, 4}};
  EXPECT_THAT(fault_of([&] { return exported(strange, LabelOrder::Place); }),
              HasSubstr("no stimulus is a phone of the ARPAbet"));
}

TEST(ExportedMatrix, PutsStimuliThatAreAlikeSideBySide) {
  const ConfusionMatrix matrix{{"p", "t", "x", "b"},
                               {"b", "other", "p", "t"},
                               {9, 0, 9, 2, 0, 1, 1, 18, 0, 0, 0, 0, 10, 0, 9, 1}};
  const auto ordered = exported(matrix, LabelOrder::Clusters);
  EXPECT_THAT(ordered.matrix.stimuli(), ElementsAre("t", "p", "b", "x"));
  EXPECT_THAT(ordered.matrix.responses(), ElementsAre("t", "p", "b", "other"));
  EXPECT_EQ(ordered.matrix.count(2, 1), 9);
}

TEST(PrintedMatrix, IsATableOfAPaperInLatex) {
  const ConfusionMatrix matrix{{"p_%", "[b"}, {"p_%", "a\\b"}, {20, 4, 0, 0.5}};
  const auto table =
      matrix_latex(ExportedMatrix{"50 % & more", {"made_up"}, matrix, LabelOrder::Given});
  EXPECT_THAT(table,
              HasSubstr("\\textit{50 \\% \\& more}\\par\\medskip\n"
                        "\\resizebox{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}"
                        "{!}{%\n\\begin{tabular}{l*{2}{r}r}\n"
                        "\\toprule\nStimulus & p\\_\\% & a\\textbackslash{}b & \\textit{n} \\\\\n"
                        "\\midrule\np\\_\\% & 20 (.83) & 4 (.17) & 24 \\\\\n"
                        "{[}b & 0 & 0.50 (1.00) & 0.50 \\\\\n\\bottomrule\n"));
  EXPECT_THAT(
      table,
      HasSubstr("n: responses in the row, 24.50 in all. Order: as given. Warning: made\\_up.\n"));
}

TEST(PrintedMatrix, IsSetByLatexWithinTheTextHoweverWide) {
  if (std::system("kpsewhich booktabs.sty >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "LaTeX with booktabs is not installed";
  }
  std::vector<std::string> labels{"\\", "~^", "{", "}$", "[b", "#1", "a_b%", "<|>", "&"};
  for (int i = 0; i < 30; ++i) labels.push_back(fmt::format("label{}", i));
  const std::vector<double> counts(labels.size() * labels.size(), 12.0);
  const auto table = matrix_latex(ExportedMatrix{
      "\\ {T} #1", {"$"}, ConfusionMatrix{labels, labels, counts}, LabelOrder::Given});
  const WrittenFiles folder;
  const auto file = folder.write("t.tex",
                                 "\\documentclass{article}\\usepackage{booktabs,graphicx}\n"
                                 "\\begin{document}\n" +
                                     table + "\\end{document}\n");
  const auto command = fmt::format("cd '{}' && pdflatex -halt-on-error {} >/dev/null 2>&1",
                                   folder.folder().string(),
                                   file.filename().string());
  ASSERT_EQ(std::system(command.c_str()), 0) << read_file(folder / "t.log");
  EXPECT_THAT(read_file(folder / "t.log"), testing::Not(HasSubstr("Overfull")));
}

TEST(PrintedMatrix, IsATableInMarkdown) {
  const ConfusionMatrix matrix{{"a|b", "*"}, {"a|b", "*"}, {20, 4, 0, 0}};
  EXPECT_THAT(
      matrix_markdown(ExportedMatrix{"T_1", {"made_up"}, matrix, LabelOrder::Given}),
      StartsWith("**T\\_1**\n\n| Stimulus | a\\|b | \\* | *n* |\n"
                 "| :--- | ---: | ---: | ---: |\n"
                 "| a\\|b | 20 (.83) | 4 (.17) | 24 |\n| \\* | 0 | 0 | 0 |\n\n*Note.* Rows"));
}

bool has_praat() {
  return std::system("command -v praat >/dev/null 2>&1") == 0;
}

/// What a script that is given to Praat prints; "FILE" in it is `file`.
std::string run_praat(const WrittenFiles& folder, std::string script, const std::string& file) {
  for (auto at = script.find("FILE"); at != std::string::npos; at = script.find("FILE")) {
    script.replace(at, 4, file);
  }
  const auto path = folder.write("script.praat", script);
  const auto output = folder / "output.txt";
  const auto command = fmt::format(
      "praat --no-pref-files --utf8 --run '{}' >'{}' 2>&1", path.string(), output.string());
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(output);
  return read_file(output);
}

TEST(ExportedMatrix, OpensInPraatWhichCountsTheSame) {
  if (!has_praat()) GTEST_SKIP() << "praat is not installed";
  const WrittenFiles folder;
  const ConfusionMatrix matrix{
      {"p", "say \"b\"", "\xC9\x94", "NA"},
      {"say \"b\"", "p", "\xC9\x94", "blank", "NA"},
      {3, 20, 0, 1, 0, 15, 5, 0.25, 2, 0, 0, 0, 9, 1.75, 0, 0, 0, 0, 0, 0}};
  const auto file = folder.write("m.Confusion", matrix_praat(exported(matrix)));
  const auto told = run_praat(folder,
                              "Read from file: \"FILE\"\n"
                              "writeInfoLine: selected$ ()\n"
                              "f = Get fraction correct\n"
                              "rows = Get number of rows\n"
                              "columns = Get number of columns\n"
                              "row$ = Get row label: 2\n"
                              "column$ = Get column label: 3\n"
                              "value = Get value: 2, 3\n"
                              "stimulus = Get stimulus sum: \"say \"\"b\"\"\"\n"
                              "response = Get response sum: \"blank\"\n"
                              "appendInfoLine: fixed$ (f, 12)\n"
                              "appendInfoLine: rows, \" \", columns, \" \", row$, \" \", column$\n"
                              "appendInfoLine: value, \" \", stimulus, \" \", response\n",
                              file.string());
  EXPECT_EQ(told,
            fmt::format("Confusion m\n{:.12f}\n4 5 say \"b\" \xC9\x94\n0.25 22.25 4.75\n",
                        matrix.correct() / matrix.total()));
}

TEST(ExportedMatrix, ReadsBackWhatPraatHasOpenedAndSaved) {
  if (!has_praat()) GTEST_SKIP() << "praat is not installed";
  const WrittenFiles folder;
  Random random{5};
  for (int round = 0; round < 5; ++round) {
    const auto matrix = random_matrix(random);
    const auto file = folder.write("m.Confusion", matrix_praat(exported(matrix)));
    for (const std::string form : {"Save as text file", "Save as short text file"}) {
      (void)run_praat(
          folder, "Read from file: \"FILE\"\n" + form + ": \"FILE.saved\"\n", file.string());
      expect_same(read_matrix(file.string() + ".saved"), matrix);
    }
  }
}

}  // namespace
}  // namespace bimodal::analysis
