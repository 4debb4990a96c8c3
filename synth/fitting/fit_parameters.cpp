#include "synth/fitting/fit_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bimodal::synth {

namespace {

constexpr std::string_view kReference = "IH";

/// The class whose alpha is 1.
std::size_t reference_class(std::span<const std::size_t> class_tokens) {
  const auto classes = part_classes();
  const auto preferred =
      static_cast<std::size_t>(std::ranges::find(classes, kReference) - classes.begin());
  if (class_tokens[preferred] > 0) return preferred;
  return static_cast<std::size_t>(std::ranges::max_element(class_tokens) - class_tokens.begin());
}

double of(std::span<const double> values, const std::optional<std::size_t>& place) {
  return place ? values[*place] : 0.0;
}

void add_to(std::span<double> slopes, const std::optional<std::size_t>& place, double slope) {
  if (place) slopes[*place] += slope;
}

}  // namespace

FitParameters::FitParameters(std::span<const MeasuredClip> clips,
                             const FitOptions& options,
                             double mean,
                             double sd)
    : mean_{mean},
      sd_{sd},
      log_theta_{std::log(options.theta_per_ms.value_or(options.theta_start_per_ms))},
      tokens_(parts().size()),
      places_(parts().size()) {
  std::vector<std::size_t> class_tokens(part_classes().size());
  for (const auto& clip : clips) {
    for (const auto& spoken : clip.spoken) {
      ++tokens_[spoken.part];
      ++class_tokens[class_of(spoken.part)];
    }
  }
  common_target_ = add(std::nullopt);
  common_offset_ = add(options.spread.common_offset_ms);
  if (!options.theta_per_ms) {
    const bool has_sides =
        options.theta == ThetaSharing::Sides || options.theta == ThetaSharing::ClassAndSide;
    common_log_theta_before_ = add(options.spread.log_theta);
    common_log_theta_after_ =
        has_sides ? add(options.spread.log_theta) : common_log_theta_before_.value();
  }
  const auto reference = reference_class(class_tokens);
  for (std::size_t i = 0; i < class_tokens.size(); ++i) {
    if (class_tokens[i] > 0) add_class(i, options, i == reference);
  }
  if (!options.own_talkers) return;
  first_talker_ = count();
  talkers_ = clips.size();
  for (std::size_t i = 0; i < talkers_; ++i) add(options.spread.talker);
}

std::size_t FitParameters::add(std::optional<double> spread) {
  spread_.push_back(spread);
  return spread_.size() - 1;
}

void FitParameters::add_class(std::size_t class_index,
                              const FitOptions& options,
                              bool is_reference) {
  const bool own_theta = !options.theta_per_ms && (options.theta == ThetaSharing::Class ||
                                                   options.theta == ThetaSharing::ClassAndSide);
  Places places;
  places.class_target = add(options.spread.class_target);
  places.offset = add(options.spread.class_offset_ms);
  if (!is_reference) places.log_alpha = add(options.spread.log_alpha);
  if (own_theta) {
    places.log_theta_before = add(options.spread.class_log_theta);
    places.log_theta_after = options.theta == ThetaSharing::ClassAndSide
                                 ? add(options.spread.class_log_theta)
                                 : places.log_theta_before.value();
  }
  for (std::size_t part = 0; part < parts().size(); ++part) {
    if (class_of(part) != class_index) continue;
    places_[part] = places;
    if (tokens_[part] > 0) places_[part].part_target = add(options.spread.part_target);
  }
}

PartDynamics FitParameters::dynamics(std::size_t part, std::span<const double> values) const {
  const auto& at = places_[part];
  const double deviation =
      values[common_target_] + of(values, at.class_target) + of(values, at.part_target);
  return {.target = mean_ + sd_ * deviation,
          .log_alpha = of(values, at.log_alpha),
          .log_theta_before =
              log_theta_ + of(values, common_log_theta_before_) + of(values, at.log_theta_before),
          .log_theta_after =
              log_theta_ + of(values, common_log_theta_after_) + of(values, at.log_theta_after),
          .offset_ms = values[common_offset_] + of(values, at.offset)};
}

void FitParameters::add_slopes(std::size_t part,
                               const PartDynamics& gradient,
                               double factor,
                               std::span<double> slopes) const {
  const auto& at = places_[part];
  const double by_target = factor * sd_ * gradient.target;
  slopes[common_target_] += by_target;
  add_to(slopes, at.class_target, by_target);
  add_to(slopes, at.part_target, by_target);
  add_to(slopes, at.log_alpha, factor * gradient.log_alpha);
  slopes[common_offset_] += factor * gradient.offset_ms;
  add_to(slopes, at.offset, factor * gradient.offset_ms);
  add_to(slopes, common_log_theta_before_, factor * gradient.log_theta_before);
  add_to(slopes, at.log_theta_before, factor * gradient.log_theta_before);
  add_to(slopes, common_log_theta_after_, factor * gradient.log_theta_after);
  add_to(slopes, at.log_theta_after, factor * gradient.log_theta_after);
}

double FitParameters::talker(std::size_t clip, std::span<const double> values) const {
  if (talkers_ == 0) return 0;
  const auto own = values.subspan(first_talker_, talkers_);
  return own[clip] - std::accumulate(own.begin(), own.end(), 0.0) / static_cast<double>(talkers_);
}

void FitParameters::add_talker_slope(std::size_t clip,
                                     double slope,
                                     std::span<double> slopes) const {
  if (talkers_ == 0) return;
  const auto own = slopes.subspan(first_talker_, talkers_);
  for (double& one : own) one -= slope / static_cast<double>(talkers_);
  own[clip] += slope;
}

}  // namespace bimodal::synth
