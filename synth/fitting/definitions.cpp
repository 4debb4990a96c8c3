#include "synth/fitting/definitions.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

namespace bimodal::synth {

namespace {

using Json = nlohmann::ordered_json;

/// With so many decimals: JSON writes the shortest text of the nearest double.
double to_digits(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  return std::round(value * scale) / scale;
}

Json definition(const PartDynamics& asked) {
  return {{"target", to_digits(asked.target, 3)},
          {"alpha", to_digits(std::exp(asked.log_alpha), 4)},
          {"theta_before_per_ms", to_digits(std::exp(asked.log_theta_before), 6)},
          {"theta_after_per_ms", to_digits(std::exp(asked.log_theta_after), 6)},
          {"exponent", 1},
          {"offset_ms", to_digits(asked.offset_ms, 2)}};
}

}  // namespace

std::optional<PartDynamics> dynamics_of(const Fit& fit, Phone segment) {
  PartDynamics mean;
  double tokens = 0;
  for (std::size_t part = 0; part < parts().size(); ++part) {
    if (parts()[part].segment != segment || fit.tokens[part] == 0) continue;
    const auto weight = static_cast<double>(fit.tokens[part]);
    const auto& asked = fit.dynamics[part];
    mean.target += weight * asked.target;
    mean.log_alpha += weight * asked.log_alpha;
    mean.log_theta_before += weight * asked.log_theta_before;
    mean.log_theta_after += weight * asked.log_theta_after;
    mean.offset_ms += weight * asked.offset_ms;
    tokens += weight;
  }
  if (tokens == 0) return std::nullopt;
  return PartDynamics{.target = mean.target / tokens,
                      .log_alpha = mean.log_alpha / tokens,
                      .log_theta_before = mean.log_theta_before / tokens,
                      .log_theta_after = mean.log_theta_after / tokens,
                      .offset_ms = mean.offset_ms / tokens};
}

std::string definitions_json(std::span<const FittedMeasure> measures,
                             std::span<const std::string> about) {
  Json definitions = Json::object();
  for (const Phone phone : all_phones()) {
    for (const auto& [name, fit] : measures) {
      const auto asked = dynamics_of(fit, phone);
      if (asked) definitions[std::string{symbol(phone)}][name] = definition(*asked);
    }
  }
  const Json all{{"definitions", definitions}, {"about", about}};
  return all.dump(2) + "\n";
}

}  // namespace bimodal::synth
