#include <cstdlib>

#include <gmock/gmock.h>

#include "analysis/report/print/blocks.hpp"
#include "analysis/report/print/figure_pdf.hpp"
#include "analysis/report/print/report_pdf.hpp"
#include "stimuli/base/error.hpp"
#include "tests/analysis/report/figure_examples.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::analysis {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kDate = "2026-11-22T10:00:00Z";

/// A page with everything that a report has.
std::string page() {
  return "<!DOCTYPE html>\n<html lang='en'><head><title>T</title><style>p &gt; b {}</style></head>"
         "<body><h1>Words &amp; faces</h1>\n<p class='lead'>Two  <b>bold</b>\n &#8211; <i>n</i></p>"
         "<div class='warnings'><h2>Before</h2><ul><li>one</li><li>two &lt;3&gt;</li></ul></div>"
         "<h2>Table</h2><table><thead><tr><th>A</th><th class='number'>n</th></tr></thead>"
         "<tbody><tr><td>x</td><td class='number'>12</td></tr>"
         "<tr class='first'><td>y</td><td class='number'>7</td></tr></tbody></table>"
         "<figure>" +
         heat_map(examples::syllables(), {.title = "Syllables"}) +
         "<figcaption><b>Figure 1.</b> A map.</figcaption></figure>"
         "<details><summary>Trials</summary><p>hidden</p></details>"
         "<details open='open'><p>shown</p></details>"
         "<figure><audio controls='controls' src='data:,'></audio><figcaption>A word"
         "</figcaption></figure><dl><dt>Term</dt><dd>meaning</dd></dl></body></html>\n";
}

TEST(PageBlocks, AreWhatThePageSays) {
  const auto blocks = read_blocks(page());
  ASSERT_EQ(blocks.size(), 12U);
  EXPECT_EQ(blocks[0].kind, Block::Kind::Heading);
  EXPECT_EQ(blocks[0].words, "Words &amp; faces");
  EXPECT_EQ(blocks[0].plain, "Words & faces");
  EXPECT_EQ(blocks[1].words, "Two <b>bold</b> \u2013 <i>n</i>");
  EXPECT_EQ(blocks[1].tone, Tone::Soft);
  EXPECT_EQ(blocks[2].tone, Tone::Warning);
  EXPECT_EQ(blocks[4].kind, Block::Kind::Item);
  EXPECT_EQ(blocks[4].words, "two &lt;3&gt;");
  const auto& table = blocks[6];
  ASSERT_EQ(table.body.size(), 2U);
  EXPECT_TRUE(table.head.at(0).cells.at(1).is_heading);
  EXPECT_TRUE(table.body[0].cells.at(1).is_number);
  EXPECT_TRUE(table.body[1].begins_group);
  EXPECT_EQ(blocks[7].words, "<b>Figure 1.</b> A map.");
  EXPECT_EQ(blocks[7].drawings.size(), 1U);
  EXPECT_EQ(blocks[8].words, "shown");
  EXPECT_THAT(blocks[9].words, HasSubstr("heard in report.html"));
  EXPECT_EQ(blocks[10].kind, Block::Kind::Term);
}

TEST(PageBlocks, RefuseAPageThatIsNotWellFormed) {
  try {
    static_cast<void>(read_blocks("<html><body>\n<p></body></html>"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("the page is not well-formed: line 2"));
  }
}

/// The words of a PDF, as poppler finds them.
std::optional<std::string> words_of(const std::string& pdf) {
  const WrittenFiles folder;
  return examples::printed_by("pdftotext -layout " + folder.write("x.pdf", pdf).string() + " -");
}

std::optional<std::string> told_of(const std::string& program, const std::string& pdf) {
  const WrittenFiles folder;
  return examples::printed_by(program + " " + folder.write("x.pdf", pdf).string());
}

TEST(ReportPdf, HasTheWordsOfThePageAndOfItsFigures) {
  const auto pdf = report_pdf(page(), kDate);
  EXPECT_THAT(pdf, StartsWith("%PDF"));
  const auto words = words_of(pdf);
  if (!words) GTEST_SKIP() << "pdftotext (poppler-utils) is not installed";
  for (const auto* const said :
       {"Words & faces", "two <3>", "Figure 1.", "no & <idea>", ".67", "shown", "meaning"}) {
    EXPECT_THAT(*words, HasSubstr(said));
  }
  EXPECT_THAT(*words, Not(HasSubstr("hidden")));
}

TEST(ReportPdf, TurnsPagesWithinTablesAndRepeatsTheirHeads) {
  std::string rows;
  for (int i = 0; i < 100; ++i) rows += "<tr><td>row</td></tr>";
  const auto pdf = report_pdf("<html><body><table><thead><tr><th>Heading</th></tr></thead><tbody>" +
                                  rows + "</tbody></table></body></html>",
                              kDate);
  const auto words = words_of(pdf);
  if (!words) GTEST_SKIP() << "pdftotext (poppler-utils) is not installed";
  std::size_t heads = 0;
  std::size_t found = 0;
  for (auto at = words->find("Heading"); at != std::string::npos;
       at = words->find("Heading", at + 1)) {
    ++heads;
  }
  for (auto at = words->find("row"); at != std::string::npos; at = words->find("row", at + 1)) {
    ++found;
  }
  EXPECT_EQ(heads, 2U);
  EXPECT_EQ(found, 100U);
}

TEST(ReportPdf, IsTheSameForTheSamePageAndDate) {
  EXPECT_EQ(report_pdf(page(), kDate), report_pdf(page(), kDate));
  EXPECT_NE(report_pdf(page(), kDate), report_pdf(page(), "2026-11-23T10:00:00Z"));
}

TEST(FigurePdf, IsAsLargeAsTheFigureWithFontsAndWithoutPictures) {
  for (const auto width : {PaperWidth::OneColumn, PaperWidth::TwoColumns}) {
    for (const auto& figure : examples::all_figures(width)) {
      const auto pdf = figure_pdf(standing_alone(figure), kDate);
      const auto told = told_of("pdfinfo", pdf);
      if (!told) GTEST_SKIP() << "pdfinfo (poppler-utils) is not installed";
      EXPECT_THAT(*told,
                  HasSubstr(width == PaperWidth::OneColumn ? "Page size:       240.94"
                                                           : "Page size:       493.2"));
      EXPECT_THAT(told_of("pdffonts", pdf).value(), HasSubstr(" yes yes yes "));
      EXPECT_THAT(told_of("pdfimages -list", pdf).value(), Not(HasSubstr("image")));
    }
  }
}

TEST(FigurePdf, HasItsLabelsAsText) {
  const auto svg = standing_alone(
      dendrogram(examples::clusters(examples::other_syllables()), PaperWidth::OneColumn));
  const auto words = words_of(figure_pdf(svg, kDate));
  if (!words) GTEST_SKIP() << "pdftotext (poppler-utils) is not installed";
  EXPECT_THAT(*words, AllOf(HasSubstr("dissimilarity (phi)"), HasSubstr("kept")));
}

TEST(FigurePdf, SaysWhyItCannotBeMade) {
  EXPECT_THROW(static_cast<void>(figure_pdf("<svg", kDate)), Error);
  EXPECT_THROW(static_cast<void>(figure_pdf(
                   "<svg xmlns='http://www.w3.org/2000/svg' width='0' height='0'/>", kDate)),
               Error);
}

}  // namespace
}  // namespace bimodal::analysis
