#include "analysis/statistics/discrimination.hpp"

#include <cassert>
#include <cmath>
#include <utility>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/toms748_solve.hpp>

namespace bimodal::analysis {

namespace {

double z(double proportion) {
  return boost::math::quantile(boost::math::normal{}, proportion);
}

}  // namespace

std::optional<YesNo> yes_no(std::int64_t hits,
                            std::int64_t signals,
                            std::int64_t false_alarms,
                            std::int64_t noises) {
  if (signals <= 0 || noises <= 0) return std::nullopt;
  assert(hits >= 0 && hits <= signals && false_alarms >= 0 && false_alarms <= noises);
  const double z_hits = z((static_cast<double>(hits) + 0.5) / (static_cast<double>(signals) + 1.0));
  const double z_alarms =
      z((static_cast<double>(false_alarms) + 0.5) / (static_cast<double>(noises) + 1.0));
  return YesNo{.sensitivity = z_hits - z_alarms, .criterion = -(z_hits + z_alarms) / 2.0};
}

double proportion_of_choices(double sensitivity, int alternatives) {
  assert(alternatives >= 2);
  const boost::math::normal normal;
  const auto density = [&](double x) {
    return boost::math::pdf(normal, x - sensitivity) *
           std::pow(boost::math::cdf(normal, x), alternatives - 1);
  };
  constexpr double kReach = 9.0;  // standard deviations: beyond lies less than 1e-18
  constexpr int kParts = 6;
  double sum = 0.0;
  for (int part = 0; part < kParts; ++part) {
    const double from = sensitivity - kReach + 2.0 * kReach * part / kParts;
    const double to = sensitivity - kReach + 2.0 * kReach * (part + 1) / kParts;
    sum +=
        boost::math::quadrature::gauss_kronrod<double, 31>::integrate(density, from, to, 10, 1e-13);
  }
  return sum;
}

std::optional<double> sensitivity_of_choices(double proportion, int alternatives) {
  if (!(proportion > 0.0 && proportion < 1.0)) return std::nullopt;
  const auto excess = [&](double sensitivity) {
    return proportion_of_choices(sensitivity, alternatives) - proportion;
  };
  constexpr double kMost = 20.0;
  if (excess(-kMost) >= 0.0) return -kMost;
  if (excess(kMost) <= 0.0) return kMost;
  std::uintmax_t steps = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(
      excess, -kMost, kMost, [](double from, double to) { return to - from < 1e-10; }, steps);
  return (low + high) / 2.0;
}

std::optional<double> sensitivity_of_choices(std::int64_t correct,
                                             std::int64_t trials,
                                             int alternatives) {
  if (trials <= 0) return std::nullopt;
  return sensitivity_of_choices(
      (static_cast<double>(correct) + 1.0 / alternatives) / (static_cast<double>(trials) + 1.0),
      alternatives);
}

}  // namespace bimodal::analysis
