#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>

#include "analysis/report/page.hpp"
#include "analysis/report/page_parts.hpp"
#include "tests/analysis/report/figure_examples.hpp"
#include "tests/analysis/report/planned_study.hpp"

namespace bimodal::analysis {
namespace {

using examples::five_conditions;
using examples::printed_by;
using examples::results_of;
using testing::HasSubstr;
using testing::Not;

Results study(const std::string& last_condition = "V <b>&\"") {
  auto conditions = five_conditions();
  conditions[3].name = last_condition;
  return results_of(conditions, 2, {.bootstrap = {.draws = 100, .seed = 1}});
}

/// With the two faces compared.
Results two_faces() {
  return results_of(five_conditions(),
                    2,
                    {.bootstrap = {.draws = 100, .seed = 1},
                     .faces = FaceConditions{"AV natural", "AV synthetic"},
                     .comparison = {.permutations = 50, .splits = 10, .seed = 1}});
}

/// What a browser without network makes of the page when a script has done something in it.
std::optional<std::string> seen_in_browser(std::string page, const std::string& deed) {
  const WrittenFiles folder;
  const std::string end = "</body>";
  page.insert(page.rfind(end), "<script>window.onload = function () {" + deed + "};</script>");
  const auto file = folder.write("page.html", page);
  return printed_by(
      "timeout 60 chromium --headless --no-sandbox --disable-gpu --host-resolver-rules='MAP * "
      "~NOTFOUND' --user-data-dir=" +
      (folder / "browser").string() + " --dump-dom file://" + file.string());
}

constexpr std::string_view kShow =
    "var shown = document.createElement('pre');"
    "shown.textContent = 'SHOWN ' + Array.from(document.querySelectorAll('.listed tbody tr'))"
    ".map(function (row) { return Array.from(row.cells).map(function (cell) {"
    " return cell.textContent; }).join('|'); }).join(';') + ' TOLD ' +"
    " document.getElementById('told').textContent + ' FOCUS ' +"
    " document.activeElement.textContent.trim() + ' END';"
    "document.body.append(shown);";

bool has_browser() {
  return printed_by("chromium --version").value_or("").find("Chromium") != std::string::npos;
}

TEST(TrialsOfACell, AreEmbeddedWithoutMarkup) {
  const auto part = part_of_trials(study());
  EXPECT_THAT(part, HasSubstr("V \\u003cb\\u003e\\u0026\\\""));
  EXPECT_THAT(std::string{page_script()}, Not(HasSubstr("<")));
  EXPECT_THAT(std::string{page_script()}, Not(HasSubstr("&")));
}

// "mat", the only word with M, is word 5: participants 0 and 1 are right with the voice alone, (3 p
// + 25) mod 7 < 3, as 4 and 0: P1 only. Trial 5 is the sixth of the first condition.
TEST(TrialsOfACell, AreListedOnAClick) {
  if (!has_browser()) GTEST_SKIP() << "chromium is not installed";
  const auto shown = seen_in_browser(
      report_page(study(), {}, {}),
      "document.querySelector(\"figure[data-unit='consonant-initial'][data-condition='A'] "
      "rect[data-cell='M M']\").dispatchEvent(new MouseEvent('click', {bubbles: true}));" +
          std::string{kShow});
  ASSERT_TRUE(shown);
  EXPECT_THAT(*shown,
              HasSubstr("SHOWN P1|A|5|mat|mat|as planned TOLD M answered M, condition A: 1 trial "
                        "FOCUS Close END"));
}

TEST(TrialsOfACell, AreListedByKeyboardAndTheListCloses) {
  if (!has_browser()) GTEST_SKIP() << "chromium is not installed";
  const std::string press =
      "function press(key) { document.activeElement.dispatchEvent(new KeyboardEvent('keydown', "
      "{key: key, bubbles: true})); }"
      "var first = document.querySelector(\"figure[data-condition='A'] rect[tabindex='0']\");"
      "first.focus(); press('ArrowRight'); var next = document.activeElement; press('Enter');";
  const auto open = seen_in_browser(report_page(study(), {}, {}), press + std::string{kShow});
  ASSERT_TRUE(open);
  EXPECT_THAT(*open, HasSubstr("|as planned"));
  EXPECT_THAT(*open, HasSubstr("FOCUS Close END"));
  const auto closed = seen_in_browser(report_page(study(), {}, {}),
                                      press +
                                          "press('Escape'); document.title = next === "
                                          "document.activeElement ? 'BACK' : 'LOST';" +
                                          std::string{kShow});
  ASSERT_TRUE(closed);
  EXPECT_THAT(*closed, HasSubstr("<title>BACK</title>"));
  EXPECT_THAT(*closed, HasSubstr("SHOWN  TOLD List closed."));
}

// "mat" again: (p w + p + 2 w) mod 5 < 4 with the natural face, as 0 and 1: both participants; (3 p
// + 25) mod 7 < 4 with the synthetic one, as 4 and 0: P1 only. The difference has the trials of
// both.
TEST(TrialsOfACell, OfTwoFacesAreThoseOfThePanelThatIsClicked) {
  if (!has_browser()) GTEST_SKIP() << "chromium is not installed";
  const auto page = report_page(two_faces(), {}, {});
  const auto shown_of = [&](const std::string& side) {
    return seen_in_browser(
               page,
               "document.querySelector(\"figure[data-unit='consonant-initial'][data-first] "
               "rect[data-cell='M M'][data-side='" +
                   side + "']\").dispatchEvent(new MouseEvent('click', {bubbles: true}));" +
                   std::string{kShow})
        .value_or("");
  };
  EXPECT_THAT(shown_of("first"),
              HasSubstr("SHOWN P0|AV natural|17|mat|mat|as planned;P1|AV natural|17|mat|mat|as "
                        "planned TOLD M answered M, condition AV natural: 2 trials FOCUS"));
  EXPECT_THAT(shown_of("second"),
              HasSubstr("SHOWN P1|AV synthetic|29|mat|mat|as planned TOLD M answered M, condition "
                        "AV synthetic: 1 trial FOCUS"));
  EXPECT_THAT(shown_of("both"),
              HasSubstr("SHOWN P0|AV natural|17|mat|mat|as planned;P1|AV natural|17|mat|mat|as "
                        "planned;P1|AV synthetic|29|mat|mat|as planned TOLD M answered M, "
                        "conditions AV natural and AV synthetic: 3 trials FOCUS"));
}

// A table without the column flagged says nothing of timing, so the list does not either.
TEST(TrialsOfACell, DoNotClaimTimingThatNobodyKnows) {
  if (!has_browser()) GTEST_SKIP() << "chromium is not installed";
  auto results = study();
  for (auto& trial : results.dataset.trials) trial.timing_known = false;
  const auto shown =
      seen_in_browser(report_page(results, {}, {}),
                      "document.querySelector(\"figure[data-condition='A'] rect[data-cell='M M']\")"
                      ".dispatchEvent(new MouseEvent('click', {bubbles: true}));" +
                          std::string{kShow});
  ASSERT_TRUE(shown);
  EXPECT_THAT(*shown, HasSubstr("SHOWN P1|A|5|mat|mat|not known TOLD"));
}

// Whoever listens to the page has to reach every panel's cells with arrows alone.
TEST(TrialsOfACell, OfTwoFacesAreReachedByKeyboardInEveryPanel) {
  if (!has_browser()) GTEST_SKIP() << "chromium is not installed";
  const auto shown = seen_in_browser(
      report_page(two_faces(), {}, {}),
      "var cells = document.querySelectorAll('figure[data-first] rect[data-cell]');"
      "var sides = {}; cells = Array.from(cells).slice(0, document.querySelector("
      "'figure[data-first]').querySelectorAll('rect[data-cell]').length);"
      "cells[0].focus(); cells.forEach(function () {"
      "sides[document.activeElement.dataset.side] = true;"
      "document.activeElement.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight', "
      "bubbles: true})); });"
      "document.title = Object.keys(sides).join(' ');");
  ASSERT_TRUE(shown);
  EXPECT_THAT(*shown, HasSubstr("<title>first second both</title>"));
}

// "eight" begins with a vowel: one trial of each of two participants.
TEST(TrialsOfACell, OfWordsWithoutTheUnitHaveAListToo) {
  if (!has_browser()) GTEST_SKIP() << "chromium is not installed";
  const auto shown =
      seen_in_browser(report_page(study(), {}, {}),
                      "Array.from(document.querySelector(\"figure[data-unit='consonant-initial']\")"
                      ".querySelectorAll('.choices button')).pop().click();" +
                          std::string{kShow});
  ASSERT_TRUE(shown);
  EXPECT_THAT(*shown, HasSubstr("SHOWN P0|A|4|eight|"));
  EXPECT_THAT(*shown, HasSubstr("Words without such a phone, condition A: 2 trials"));
}

}  // namespace
}  // namespace bimodal::analysis
