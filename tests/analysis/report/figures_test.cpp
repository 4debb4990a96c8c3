#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>

#include <gmock/gmock.h>
#include <libxml/parser.h>

#include "analysis/report/figures/colours.hpp"
#include "analysis/report/figures/label_places.hpp"
#include "analysis/report/figures/share_axis.hpp"
#include "tests/analysis/report/figure_examples.hpp"

namespace bimodal::analysis {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::Ge;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr std::array kWidths{PaperWidth::OneColumn, PaperWidth::TwoColumns};

/// libxml2's verdict.
bool is_well_formed(const std::string& xml) {
  const std::unique_ptr<xmlDoc, void (*)(xmlDoc*)> document{
      xmlReadMemory(xml.data(), static_cast<int>(xml.size()), "figure", "UTF-8", XML_PARSE_NOERROR),
      &xmlFreeDoc};
  return document != nullptr;
}

/// All numbers that the expression finds in the figure.
std::vector<double> numbers(const std::string& figure, const std::string& expression) {
  const std::regex pattern{expression};
  std::vector<double> found;
  for (std::sregex_iterator at{figure.begin(), figure.end(), pattern}; at != std::sregex_iterator{};
       ++at) {
    found.push_back(std::strtod((*at)[1].str().c_str(), nullptr));
  }
  return found;
}

std::size_t times(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Figures, AreWellFormedAndTellWhatTheyShow) {
  for (const auto width : kWidths) {
    for (const auto& figure : examples::all_figures(width)) {
      EXPECT_TRUE(is_well_formed(figure)) << figure.substr(0, 300);
      EXPECT_THAT(figure,
                  AllOf(StartsWith("<svg "),
                        HasSubstr("role='img'"),
                        HasSubstr("aria-label='"),
                        HasSubstr("<title>"),
                        HasSubstr("<text"),
                        Not(HasSubstr("<script")),
                        Not(HasSubstr("='nan")),
                        Not(HasSubstr("='inf"))));
    }
  }
}

TEST(Figures, AreAsWideAsAJournalsColumnsInLettersThatCanBeRead) {
  for (const auto width : kWidths) {
    for (const auto& figure : examples::all_figures(width)) {
      EXPECT_THAT(numbers(figure, "width='([0-9.]+)mm'"), ElementsAre(millimetres(width)));
      EXPECT_THAT(numbers(figure, "font-size='([0-9.]+)'"), Each(Ge(5.0)));
      // A point of the paper is a unit of the drawing: 85 mm are 240.945 points.
      EXPECT_NEAR(numbers(figure, "viewBox='0 0 ([0-9.]+)").at(0), points(width), 0.01);
    }
  }
  EXPECT_NEAR(points(PaperWidth::OneColumn), 240.945, 0.001);
}

TEST(Figures, DrawNothingBeyondTheirEdges) {
  for (const auto width : kWidths) {
    for (const auto& figure : examples::all_figures(width)) {
      for (const double x : numbers(figure, " x='(-?[0-9.]+)'")) {
        EXPECT_GE(x, 0.0);
        EXPECT_LE(x, points(width) + 0.01);
      }
    }
  }
}

TEST(HeatMap, PrintsProportionsOrCountsWhereThereIsRoom) {
  const auto matrix = examples::syllables();
  const auto shares = heat_map(matrix, {.title = "Syllables"});
  EXPECT_THAT(shares, HasSubstr(">.67</text>"));  // 40 of 60
  EXPECT_THAT(shares, HasSubstr("<title>p answered b: .10 (6 of 60)</title>"));
  EXPECT_THAT(shares, HasSubstr("5 stimuli, 240 responses, 65.4 % correct."));
  EXPECT_THAT(shares, HasSubstr("no &amp; &lt;idea&gt;"));
  const auto counts =
      heat_map(matrix, {.title = "Syllables", .numbers = HeatMapOptions::Numbers::Counts});
  EXPECT_THAT(counts, AllOf(HasSubstr(">40</text>"), Not(HasSubstr(">.67</text>"))));
  // 24 columns over 85 mm: cells of less than 10 points.
  EXPECT_THAT(heat_map(examples::consonants(), {.width = PaperWidth::OneColumn}),
              Not(HasSubstr(">1.00</text>")));
}

TEST(HeatMap, ShowsStimuliThatWereNotPresentedAsUnknown) {
  const auto map = heat_map(examples::syllables(), {.title = "Syllables"});
  EXPECT_EQ(times(map, "<title>n was not presented</title>"), 6U);
  EXPECT_THAT(heat_map(ConfusionMatrix{{"B"}, {"B", "blank"}}, {}), HasSubstr("No responses."));
  EXPECT_TRUE(is_well_formed(heat_map(ConfusionMatrix{}, {})));
}

TEST(HeatMap, GivesRareConfusionsMoreColourOnASquareRootScale) {
  const ConfusionMatrix matrix{{"p"}, {"p", "b"}, {75, 25}};
  EXPECT_THAT(heat_map(matrix, {}), HasSubstr(sequential_colour(0.25)));
  const auto root = heat_map(matrix, {.is_square_root = true});
  EXPECT_THAT(root, HasSubstr(sequential_colour(0.5)));
  EXPECT_THAT(root, HasSubstr("square-root"));
}

TEST(Arrangement, OrdersLabelsAndPartsClasses) {
  const auto matrix = examples::syllables();
  const auto axes = arrange(
      matrix,
      {.order = {"m", "n", "t"}, .order_name = "mine", .classes = {{"m", "n"}, {"p", "b"}}});
  EXPECT_THAT(axes.rows, ElementsAre(2, 4, 3, 0, 1));
  EXPECT_THAT(axes.columns, ElementsAre(2, 4, 3, 0, 1, 5));
  EXPECT_EQ(axes.extras, 1U);
  EXPECT_THAT(axes.row_borders, ElementsAre(false, false, true, true, false));
  EXPECT_THAT(arrange(examples::consonants(), {}).row_borders.at(3), true);  // M | W
}

TEST(PairFigure, OutlinesSignificantCellsAndTellsTheScale) {
  const auto figure = pair_figure(examples::pair(), {}, PaperWidth::TwoColumns);
  EXPECT_EQ(times(figure, "stroke='#000000' stroke-width='1'"), 2U);
  EXPECT_THAT(figure, HasSubstr("2 cells outlined: permutation test, false discovery rate .05."));
  EXPECT_THAT(figure, HasSubstr("p answered b: .10 and .43, difference \u2212.33"));
  EXPECT_THAT(figure, HasSubstr("from \u22120.4 to 0.4"));  // .33, rounded up
  EXPECT_EQ(times(figure, "<title>n was not presented in both</title>"), 6U);
  auto untested = examples::pair();
  untested.significant.clear();
  EXPECT_THAT(pair_figure(untested, {}, PaperWidth::TwoColumns),
              AllOf(Not(HasSubstr("outlined")), HasSubstr("Differences are not tested.")));
}

TEST(PairFigure, PutsTheDifferenceBelowWhereCellsWouldBeTooSmall) {
  const auto tops = [](const ConfusionMatrix& matrix) {
    const ConditionPair pair{.title = "Consonants",
                             .natural = "one",
                             .synthetic = "two",
                             .natural_matrix = matrix,
                             .synthetic_matrix = matrix,
                             .significant = {},
                             .test = {}};
    auto found = numbers(pair_figure(pair, {}, PaperWidth::TwoColumns),
                         "y='([0-9.]+)'[^>]*font-weight='bold'");
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found.size();
  };
  EXPECT_EQ(tops(examples::syllables()), 1U);
  EXPECT_EQ(tops(examples::consonants()), 2U);
}

TEST(ProportionFigure, TellsEveryNumber) {
  const auto figure =
      proportion_figure(examples::bars(), "proportion correct", PaperWidth::OneColumn);
  EXPECT_THAT(figure,
              HasSubstr("auditory: .55 [.50, .60], 2 participants; visual &amp; &lt;only&gt;"));
  EXPECT_THAT(figure, HasSubstr("<title>P&lt;1&gt;: .50</title>"));
  EXPECT_EQ(times(figure, "<circle"), 2U);
}

TEST(BenefitFigure, HasAMarkForEveryParticipant) {
  const auto figure = benefit_figure(examples::benefits(), "auditory", PaperWidth::OneColumn);
  EXPECT_THAT(figure, HasSubstr("natural: 2 participants, mean benefit .25; synthetic: 1 "));
  EXPECT_THAT(figure, HasSubstr("<title>P1, synthetic: A .50, AV .40, benefit \u2212.10</title>"));
  EXPECT_EQ(times(figure, "</title></circle>"), 2U);
  EXPECT_THAT(figure, HasSubstr("largest possible"));
  EXPECT_TRUE(is_well_formed(benefit_figure({}, "auditory", PaperWidth::OneColumn)));
}

TEST(FeatureFigure, TellsBothEstimates) {
  const auto figure = feature_figure(examples::features(), PaperWidth::TwoColumns);
  EXPECT_THAT(figure, AllOf(HasSubstr(">.78 (.81)</text>"), HasSubstr(">\u2212.02 (.05)</text>")));
  EXPECT_TRUE(is_well_formed(feature_figure({}, PaperWidth::OneColumn)));
}

TEST(Dendrogram, CutsBetweenTheLastMergeWithinClassesAndTheFirstBetweenThem) {
  const auto table = examples::clusters(examples::other_syllables());
  const auto figure = dendrogram(table, PaperWidth::OneColumn);
  EXPECT_EQ(times(figure, "<path d='M"), table.merges.size() + table.classes.size());
  EXPECT_EQ(times(figure, " kept</text>"), table.classes.size());
  EXPECT_THAT(figure, HasSubstr("average linkage of dissimilarities by phi"));
  const auto alone = dendrogram(examples::clusters({{"p"}, {"p"}, {3.0}}), PaperWidth::OneColumn);
  EXPECT_THAT(alone, HasSubstr("1.00 kept"));
}

TEST(LabelPlaces, KeepLabelsApartFromEachOtherAndFromPoints) {
  const std::vector<PlotPoint> points{{50, 50}, {52, 50}, {50, 53}, {49, 48}, {99, 99}};
  const std::vector<double> widths(points.size(), 12.0);
  const Box bounds{0, 0, 100, 100};
  const auto boxes = place_labels(points, widths, 8.0, 1.5, bounds);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_GE(boxes[i].left, 0.0);
    EXPECT_LE(boxes[i].left + boxes[i].width, 100.0);
    EXPECT_LE(boxes[i].top + boxes[i].height, 100.0);
    for (std::size_t k = 0; k < i; ++k) {
      const bool apart = std::abs(boxes[i].left - boxes[k].left) >= 12.0 ||
                         std::abs(boxes[i].top - boxes[k].top) >= 8.0;
      EXPECT_TRUE(apart) << i << ' ' << k;
    }
  }
}

/// By hand: a square with a point within and one on an edge.
TEST(ConvexHull, HasTheCornersOnly) {
  const auto hull = convex_hull({{0, 0}, {2, 2}, {1, 1}, {2, 0}, {0, 2}, {1, 0}, {2, 2}});
  std::vector<std::pair<double, double>> corners;
  for (const auto& corner : hull) corners.emplace_back(corner.x, corner.y);
  using Corner = std::pair<double, double>;
  EXPECT_THAT(corners, ElementsAre(Corner{0, 0}, Corner{2, 0}, Corner{2, 2}, Corner{0, 2}));
  EXPECT_EQ(convex_hull({{1, 1}, {1, 1}}).size(), 1U);
}

/// The ends and the middle of ColorBrewer's schemes, as published.
TEST(Colours, AreThoseOfColorBrewer) {
  EXPECT_EQ(sequential_colour(0.0), "#ffffff");
  EXPECT_EQ(sequential_colour(0.5), "#6baed6");
  EXPECT_EQ(sequential_colour(1.0), "#08306b");
  EXPECT_EQ(diverging_colour(-1.0), "#7f3b08");
  EXPECT_EQ(diverging_colour(0.0), "#ffffff");
  EXPECT_EQ(diverging_colour(1.0), "#2d004b");
  EXPECT_EQ(ink_on("#08306b"), "#ffffff");
  EXPECT_EQ(ink_on("#c6dbef"), "#000000");
  EXPECT_EQ(series_colour(0), "#0072b2");
}

TEST(Wrapped, PartsAtSpacesAndHyphens) {
  EXPECT_THAT(wrapped("audio-visual face", 8.0, 40.0), ElementsAre("audio-", "visual", "face"));
  EXPECT_THAT(wrapped("face", 8.0, 2.0), ElementsAre("face"));
}

}  // namespace
}  // namespace bimodal::analysis
