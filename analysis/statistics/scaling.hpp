#pragma once

#include <cstddef>
#include <vector>

#include "analysis/statistics/dissimilarity.hpp"

namespace bimodal::analysis {

/// Things laid out so that distances between them are as their dissimilarities.
struct Layout {
  std::size_t dimensions = 0;
  std::vector<double> coordinates;  ///< thing by thing, `dimensions` each
  std::vector<double> eigenvalues;  ///< all, descending; negative ones: no layout is exact
  /// The part of the sum of the positive eigenvalues that the dimensions have; 0 if there are none.
  double share = 0.0;
  /// Stress-1 (Kruskal, 1964, Psychometrika 29, 1-27) of the layout: sqrt(sum (d - delta)^2 / sum
  /// d^2) over all pairs, d the distances laid out and delta the dissimilarities themselves; 0 if
  /// all d are 0.
  double stress = 0.0;
};

/// Classical multidimensional scaling (Torgerson, 1952, Psychometrika 17, 401-419): eigenvectors of
/// -1/2 J D^2 J, D the dissimilarities and J what takes the means off. The sign of a dimension says
/// nothing: the coordinate farthest from 0 is positive. `dimensions` beyond the positive
/// eigenvalues are 0.
[[nodiscard]] Layout scale_classically(const Dissimilarities& unlike, std::size_t dimensions);

}  // namespace bimodal::analysis
