#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "synth/fitting/fit_options.hpp"
#include "synth/fitting/part_dynamics.hpp"

namespace bimodal::synth {

/// The free parameters of a fit, in one vector, and what they mean for each part:
///   target = mean + sd (common + class + part)      log_alpha = class
///   offset = common + class                          log_theta = start + common + class
/// Parts and classes that occur in no clip have no parameters; what is common to all, or to their
/// class, stands for them. A common factor of all alphas changes nothing: the class with most
/// tokens has alpha 1 (IH if it is among those that occur, as in the fit to natural lips).
class FitParameters {
 public:
  /// `mean` and `sd` are those of all measured values.
  FitParameters(std::span<const MeasuredClip> clips,
                const FitOptions& options,
                double mean,
                double sd);

  /// How many there are.
  [[nodiscard]] std::size_t count() const { return spread_.size(); }

  /// Of each parameter, the standard deviation that it is taken to have; absent: free.
  [[nodiscard]] std::span<const std::optional<double>> spread() const { return spread_; }

  [[nodiscard]] PartDynamics dynamics(std::size_t part, std::span<const double> values) const;

  /// Adds to `slopes`, one per parameter, `factor` times the derivatives by a part's numbers.
  void add_slopes(std::size_t part,
                  const PartDynamics& gradient,
                  double factor,
                  std::span<double> slopes) const;

  /// The log gain, or the offset in sd, of a clip: its parameter minus the mean of all clips', so
  /// that targets are those of the mean talker. 0 if talkers are alike.
  [[nodiscard]] double talker(std::size_t clip, std::span<const double> values) const;

  /// Adds to `slopes` those by a clip's log gain or offset.
  void add_talker_slope(std::size_t clip, double slope, std::span<double> slopes) const;

  /// How often each part, by its index, occurs in the clips.
  [[nodiscard]] std::span<const std::size_t> tokens() const { return tokens_; }

 private:
  using Index = std::optional<std::size_t>;

  /// Where a part's parameters stand; absent ones are zero.
  struct Places {
    Index class_target;
    Index part_target;
    Index log_alpha;
    Index offset;
    Index log_theta_before;
    Index log_theta_after;
  };

  std::size_t add(std::optional<double> spread);
  void add_class(std::size_t class_index, const FitOptions& options, bool is_reference);

  double mean_;
  double sd_;
  double log_theta_;  ///< where the common ones start, or the fixed one
  std::vector<std::optional<double>> spread_;
  std::vector<std::size_t> tokens_;
  std::vector<Places> places_;  ///< one per part of parts()
  std::size_t common_target_ = 0;
  std::size_t common_offset_ = 0;
  Index common_log_theta_before_;
  Index common_log_theta_after_;
  std::size_t first_talker_ = 0;
  std::size_t talkers_ = 0;  ///< clips with one of their own
};

}  // namespace bimodal::synth
