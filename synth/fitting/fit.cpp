#include "synth/fitting/fit.hpp"

#include <cassert>
#include <memory>

#include <ceres/ceres.h>

#include "synth/fitting/fit_problem.hpp"

namespace bimodal::synth {

namespace {

constexpr int kMostSteps = 300;
constexpr double kTolerance = 1e-10;  // of the cost, relative

/// All residuals by all parameters, as one block: the problem is small and dense.
class AllResiduals final : public ceres::CostFunction {
 public:
  explicit AllResiduals(const FitProblem& problem) : problem_{problem} {
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.parameter_count()));
    set_num_residuals(static_cast<int>(problem.residual_count()));
  }

  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override {
    const auto columns = problem_.parameter_count();
    const auto rows = problem_.residual_count();
    const bool wants_slopes = jacobians != nullptr && jacobians[0] != nullptr;
    problem_.evaluate(
        {parameters[0], columns},
        {residuals, rows},
        wants_slopes ? std::span<double>{jacobians[0], rows * columns} : std::span<double>{});
    return true;
  }

 private:
  const FitProblem& problem_;
};

std::vector<PartDynamics> dynamics_of(const FitProblem& problem, std::span<const double> values) {
  std::vector<PartDynamics> dynamics;
  dynamics.reserve(parts().size());
  for (std::size_t part = 0; part < parts().size(); ++part) {
    dynamics.push_back(problem.parameters().dynamics(part, values));
  }
  return dynamics;
}

}  // namespace

Fit fit(std::span<const MeasuredClip> clips, const FitOptions& options) {
  assert(!clips.empty() && options.shrinkage >= 0);
  const FitProblem squares{clips, options};
  std::vector<double> values(squares.parameter_count(), 0.0);
  ceres::Problem problem;
  problem.AddResidualBlock(
      std::make_unique<AllResiduals>(squares).release(), nullptr, values.data());
  ceres::Solver::Options how;
  how.linear_solver_type = ceres::DENSE_QR;
  how.logging_type = ceres::SILENT;
  how.max_num_iterations = kMostSteps;
  how.function_tolerance = kTolerance;
  how.num_threads = 1;
  ceres::Solver::Summary summary;
  ceres::Solve(how, &problem, &summary);

  const auto tokens = squares.parameters().tokens();
  Fit found{.kind = options.kind,
            .dynamics = dynamics_of(squares, values),
            .tokens = {tokens.begin(), tokens.end()},
            .cost = summary.final_cost,
            .steps = static_cast<int>(summary.iterations.size()) - 1,
            .converged = summary.termination_type == ceres::CONVERGENCE};
  for (std::size_t i = 0; i < clips.size(); ++i) {
    found.talkers.push_back(squares.talker(i, values));
  }
  return found;
}

std::vector<double> predicted(const Fit& fit, const MeasuredClip& clip, double talker) {
  std::vector<PartDynamics> asked;
  asked.reserve(clip.spoken.size());
  for (const auto& one : clip.spoken) asked.push_back(fit.dynamics[one.part]);
  std::vector<double> values;
  values.reserve(clip.time_ms.size());
  for (const double time : clip.time_ms) {
    values.push_back(shown(fit.kind, blended(clip.spoken, asked, time), talker));
  }
  return values;
}

}  // namespace bimodal::synth
