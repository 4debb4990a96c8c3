// What R computes of the matrices in tests/oracles/inputs, by the scripts beside them, is what we
// compute (`./dev oracles` runs the scripts again).

#include <cmath>
#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/data/feature_file.hpp"
#include "analysis/statistics/clustering.hpp"
#include "analysis/statistics/information.hpp"
#include "analysis/statistics/interval.hpp"
#include "analysis/statistics/scaling.hpp"
#include "tests/analysis/oracle_values.hpp"

namespace bimodal::analysis {
namespace {

using oracles::input;
using oracles::kTolerance;
using oracles::phi_of;
using oracles::stored_values;

TEST(Oracles, IntervalsOfProportions) {
  for (const auto& line : stored_values("intervals")) {
    const auto method = std::ranges::find_if(
        kIntervalMethods, [&](IntervalMethod some) { return name(some) == line.text("method"); });
    ASSERT_NE(method, kIntervalMethods.end()) << line.text("method");
    const auto k = static_cast<std::int64_t>(line.index("k"));
    const auto n = static_cast<std::int64_t>(line.index("n"));
    const auto found = interval_of(*method, k, n, line.number("level")).value();
    SCOPED_TRACE(fmt::format("{}, {} of {}", line.text("method"), k, n));
    EXPECT_NEAR(found.low, line.number("low"), kTolerance);
    EXPECT_NEAR(found.high, line.number("high"), kTolerance);
  }
}

TEST(Oracles, DissimilaritiesOfRows) {
  for (const auto& line : stored_values("phi")) {
    const auto unlike = phi_of(line.text("matrix"));
    const auto index = [&](const std::string& column) {
      const auto found = std::ranges::find(unlike.labels(), line.text(column));
      return static_cast<std::size_t>(found - unlike.labels().begin());
    };
    EXPECT_NEAR(unlike.between(index("one"), index("other")), line.number("phi"), kTolerance);
  }
}

TEST(Oracles, Clusters) {
  const std::map<std::string, Linkage> linkages{
      {"single", Linkage::Single}, {"complete", Linkage::Complete}, {"average", Linkage::Average}};
  for (const auto& line : stored_values("clusters")) {
    SCOPED_TRACE(line.text("matrix") + " " + line.text("linkage"));
    const auto merges = cluster(phi_of(line.text("matrix")), linkages.at(line.text("linkage")));
    const auto& merge = merges.at(line.index("merge"));
    EXPECT_EQ(merge.one, line.index("one"));
    EXPECT_EQ(merge.other, line.index("other"));
    EXPECT_NEAR(merge.height, line.number("height"), kTolerance);
  }
}

double distance_in(const Layout& layout, std::size_t one, std::size_t other) {
  double squares = 0.0;
  for (std::size_t k = 0; k < layout.dimensions; ++k) {
    const double along = layout.coordinates[one * layout.dimensions + k] -
                         layout.coordinates[other * layout.dimensions + k];
    squares += along * along;
  }
  return std::sqrt(squares);
}

/// As R's dist() lists them: all with the first thing, then the others with the second ...
std::vector<double> distances_in(const Layout& layout, std::size_t things) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < things; ++i) {
    for (std::size_t j = i + 1; j < things; ++j) distances.push_back(distance_in(layout, i, j));
  }
  return distances;
}

TEST(Oracles, Layouts) {
  for (const auto& line : stored_values("layout")) {
    const auto unlike = phi_of(line.text("matrix"));
    const auto layout = scale_classically(unlike, 2);
    const std::map<std::string, std::vector<double>> found{
        {"eigenvalue", layout.eigenvalues},
        {"distance", distances_in(layout, unlike.size())},
        {"stress_1", {layout.stress}}};
    EXPECT_NEAR(
        found.at(line.text("quantity")).at(line.index("index")), line.number("value"), kTolerance)
        << line.text("matrix") << ", " << line.text("quantity") << " " << line.text("index");
  }
}

double quantity_of(const Information& found, const std::string& quantity) {
  return std::map<std::string, double>{{"n", found.responses},
                                       {"stimulus_entropy", found.stimulus_entropy},
                                       {"response_entropy", found.response_entropy},
                                       {"joint_entropy", found.joint_entropy},
                                       {"transmitted", found.transmitted},
                                       {"relative", found.relative.value_or(std::nan(""))},
                                       {"miller_madow", found.miller_madow},
                                       {"all_cells_possible", found.all_cells_possible}}
      .at(quantity);
}

TEST(Oracles, Information) {
  const auto features = read_features(oracles::folder() / "inputs/features.csv");
  for (const auto& line : stored_values("information")) {
    auto matrix = input(line.text("matrix"));
    const auto feature = std::ranges::find(features.features, line.text("feature"));
    if (feature != features.features.end()) {
      const auto index = static_cast<std::size_t>(feature - features.features.begin());
      matrix = grouped(matrix,
                       features.values_of(matrix.stimuli(), index),
                       features.values_of(matrix.responses(), index));
    }
    const auto found = information(matrix).value();
    EXPECT_NEAR(quantity_of(found, line.text("quantity")), line.number("value"), kTolerance)
        << line.text("matrix") << ", " << line.text("feature") << ", " << line.text("quantity");
  }
}

TEST(Oracles, LikenessOfErrors) {
  const auto one = input("natural");
  const auto other = input("synthetic");
  for (const auto& line : stored_values("likeness_cells")) {
    if (line.text("scope") != "off-diagonal") continue;
    std::vector<std::string> ignored;
    if (line.text("ignored") != "none") ignored.push_back(line.text("ignored"));
    const auto likeness = compare_errors(one, other, ignored);
    const std::map<std::string, double> found{{"cells", static_cast<double>(likeness.cells)},
                                              {"pearson", likeness.correlation.value()},
                                              {"rmsd", likeness.rms_deviation.value()}};
    const auto quantity = found.find(line.text("quantity"));
    if (quantity == found.end()) continue;  // of those that compare_errors does not give
    EXPECT_NEAR(quantity->second, line.number("value"), kTolerance) << quantity->first;
  }
}

}  // namespace
}  // namespace bimodal::analysis
