#include "analysis/statistics/scaling.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace bimodal::analysis {

namespace {

constexpr double kRounding = 1e-12;  ///< of the largest eigenvalue: not more than 0

Eigen::MatrixXd doubly_centred_squares(const Dissimilarities& unlike) {
  const auto n = static_cast<Eigen::Index>(unlike.size());
  Eigen::MatrixXd squares{n, n};
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const double delta = unlike.between(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
      squares(i, j) = delta * delta;
    }
  }
  const Eigen::MatrixXd centre =
      Eigen::MatrixXd::Identity(n, n) -
      Eigen::MatrixXd::Constant(n, n, 1.0 / static_cast<double>(std::max<Eigen::Index>(n, 1)));
  return -0.5 * centre * squares * centre;
}

double stress_of(const Eigen::MatrixXd& places, const Dissimilarities& unlike) {
  double misfit = 0.0;
  double whole = 0.0;
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      const double distance = (places.row(i) - places.row(j)).norm();
      const double delta = unlike.between(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
      misfit += (distance - delta) * (distance - delta);
      whole += distance * distance;
    }
  }
  return whole > 0.0 ? std::sqrt(misfit / whole) : 0.0;
}

}  // namespace

Layout scale_classically(const Dissimilarities& unlike, std::size_t dimensions) {
  const auto n = static_cast<Eigen::Index>(unlike.size());
  Layout layout{.dimensions = dimensions, .coordinates = {}, .eigenvalues = {}};
  if (n == 0) return layout;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{doubly_centred_squares(unlike)};
  Eigen::MatrixXd places = Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(dimensions));
  double positive = 0.0;
  double shown = 0.0;
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto from_smallest = n - 1 - k;
    const double value = solver.eigenvalues()(from_smallest);
    layout.eigenvalues.push_back(value);
    if (value <= kRounding * solver.eigenvalues()(n - 1)) continue;
    positive += value;
    if (k >= places.cols()) continue;
    shown += value;
    places.col(k) = solver.eigenvectors().col(from_smallest) * std::sqrt(value);
    Eigen::Index farthest = 0;
    places.col(k).cwiseAbs().maxCoeff(&farthest);
    if (places(farthest, k) < 0.0) places.col(k) *= -1.0;
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k < places.cols(); ++k) layout.coordinates.push_back(places(i, k));
  }
  layout.share = positive > 0.0 ? shown / positive : 0.0;
  layout.stress = stress_of(places, unlike);
  return layout;
}

}  // namespace bimodal::analysis
