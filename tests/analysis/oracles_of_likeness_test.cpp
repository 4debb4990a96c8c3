// What R computes of correlations, of two matrices and of sensitivities, by the scripts in
// tests/oracles, is what we compute (`./dev oracles` runs the scripts again).

#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/statistics/correlation.hpp"
#include "analysis/statistics/discrimination.hpp"
#include "analysis/statistics/matrix_comparison.hpp"
#include "tests/analysis/oracle_values.hpp"

namespace bimodal::analysis {
namespace {

using oracles::input;
using oracles::kTolerance;
using oracles::phi_of;
using oracles::stored_values;

std::vector<double> numbers(const std::string& text) {
  std::vector<double> read;
  std::istringstream stream{text};
  for (double value = 0.0; stream >> value;) read.push_back(value);
  return read;
}

TEST(Oracles, Correlations) {
  for (const auto& line : stored_values("correlations")) {
    SCOPED_TRACE(line.text("series"));
    const auto xs = numbers(line.text("x"));
    const auto ys = numbers(line.text("y"));
    EXPECT_NEAR(pearson(xs, ys).value(), line.number("pearson"), kTolerance);
    EXPECT_NEAR(spearman(xs, ys).value(), line.number("spearman"), kTolerance);
  }
}

TEST(Oracles, FalseDiscoveryRates) {
  std::map<std::string, std::vector<double>> families;
  const auto lines = stored_values("false_discovery");
  for (const auto& line : lines) families[line.text("family")].push_back(line.number("p"));
  for (const auto& line : lines) {
    const auto adjusted = false_discovery_rates(families.at(line.text("family")));
    EXPECT_NEAR(adjusted.at(line.index("index")), line.number("adjusted"), kTolerance)
        << line.text("family") << " " << line.text("index");
  }
}

/// Without the column of blank answers, if that is to be ignored.
ConfusionMatrix input_without(const std::string& name, const std::string& ignored) {
  const auto matrix = input(name);
  if (ignored == "none") return matrix;
  auto responses = matrix.responses();
  std::erase(responses, ignored);
  ConfusionMatrix kept{matrix.stimuli(), responses};
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
      const auto& response = matrix.responses()[j];
      if (response != ignored) kept.add(matrix.stimuli()[i], response, matrix.count(i, j));
    }
  }
  return kept;
}

TEST(Oracles, AgreementOfCells) {
  for (const auto& line : stored_values("likeness_cells")) {
    const auto found = agreement_of_cells(input_without("natural", line.text("ignored")),
                                          input_without("synthetic", line.text("ignored")),
                                          line.text("scope") == "off-diagonal");
    const std::map<std::string, double> quantities{{"cells", static_cast<double>(found.cells)},
                                                   {"pearson", found.pearson.value()},
                                                   {"spearman", found.spearman.value()},
                                                   {"rmsd", found.rms_difference.value()}};
    EXPECT_NEAR(quantities.at(line.text("quantity")), line.number("value"), kTolerance)
        << line.text("ignored") << ", " << line.text("scope") << ", " << line.text("quantity");
  }
}

TEST(Oracles, ComparisonOfRows) {
  for (const auto& line : stored_values("likeness_rows")) {
    SCOPED_TRACE(line.text("stimulus") + ", ignored: " + line.text("ignored"));
    const auto found = compare_matrices(input_without("natural", line.text("ignored")),
                                        input_without("synthetic", line.text("ignored")));
    const auto row = std::ranges::find(found.rows, line.text("stimulus"), &RowComparison::stimulus);
    ASSERT_NE(row, found.rows.end());
    EXPECT_EQ(row->n_one, line.number("n_one"));
    EXPECT_EQ(row->n_other, line.number("n_other"));
    EXPECT_NEAR(row->chi_square, line.number("chi_square"), kTolerance);
    EXPECT_EQ(row->degrees, static_cast<std::int64_t>(line.index("df")));
    EXPECT_NEAR(row->divergence, line.number("divergence_bits"), kTolerance);
  }
}

/// The sums of R's rows; their p by scipy 1.10.1, stats.chi2.sf; G by its
/// chi2_contingency(lambda_="log-likelihood") of each row.
TEST(Oracles, ComparisonOfAllRows) {
  const auto found = compare_matrices(input("natural"), input("synthetic"));
  EXPECT_NEAR(found.chi_square, 48.34042441865065, kTolerance);
  EXPECT_EQ(found.degrees, 43);
  EXPECT_NEAR(found.chi_square_p.value(), 0.26602581439756806, kTolerance);
  EXPECT_NEAR(found.g, 58.744614954948304, kTolerance);
  EXPECT_NEAR(found.correct_one.value(), 168.0 / 325, kTolerance);
  EXPECT_NEAR(found.accuracy_ratio.value(), (112.0 / 320) / (168.0 / 325), kTolerance);
  EXPECT_THAT(found.not_compared, testing::IsEmpty());
}

/// The mean of the two proportions with which each is answered for the other.
Dissimilarities symmetrised(const ConfusionMatrix& matrix) {
  Dissimilarities found{matrix.stimuli()};
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      found.set(i, j, (matrix.proportion(i, j).value() + matrix.proportion(j, i).value()) / 2.0);
    }
  }
  return found;
}

TEST(Oracles, MantelByAllOrders) {
  const std::map<std::string, Mantel> tests{
      {"phi", mantel(phi_of("five_one"), phi_of("five_other"), 9'999, 1).value()},
      {"symmetrised",
       mantel(symmetrised(input("five_one")), symmetrised(input("five_other")), 9'999, 1).value()}};
  for (const auto& line : stored_values("mantel")) {
    const auto& found = tests.at(line.text("measure"));
    EXPECT_TRUE(found.enumerated);
    const std::map<std::string, double> quantities{
        {"r", found.r},
        {"orders", static_cast<double>(found.permutations)},
        {"at_least", found.p * static_cast<double>(found.permutations)},
        {"p", found.p}};
    const auto quantity = quantities.find(line.text("quantity"));
    if (quantity == quantities.end())
      continue;  // of the distribution, which mantel() does not give
    EXPECT_NEAR(quantity->second, line.number("value"), kTolerance)
        << line.text("measure") << ", " << line.text("quantity");
  }
}

TEST(Oracles, SensitivityOfYesAndNo) {
  for (const auto& line : stored_values("yes_no")) {
    const auto whole = [&](const char* column) {
      return static_cast<std::int64_t>(line.index(column));
    };
    const auto found =
        yes_no(whole("hits"), whole("signals"), whole("false_alarms"), whole("noises")).value();
    EXPECT_NEAR(found.sensitivity, line.number("d_prime"), kTolerance);
    EXPECT_NEAR(found.criterion, line.number("criterion"), kTolerance);
  }
}

TEST(Oracles, SensitivityOfChoices) {
  for (const auto& line : stored_values("alternatives")) {
    const auto alternatives = static_cast<int>(line.index("alternatives"));
    const auto found = sensitivity_of_choices(line.number("proportion"), alternatives);
    EXPECT_NEAR(found.value(), line.number("d_prime"), kTolerance)
        << line.text("alternatives") << ", " << line.text("proportion");
  }
}

}  // namespace
}  // namespace bimodal::analysis
