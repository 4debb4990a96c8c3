#include "analysis/report/provenance.hpp"

#include <fmt/format.h>

namespace bimodal::analysis {

Provenance provenance_of(const Dataset& dataset, std::string program) {
  Provenance provenance;
  provenance.program = std::move(program);
  provenance.files = dataset.files;
  provenance.stored_trials = dataset.stored_trials;
  provenance.analysed_trials = static_cast<std::int64_t>(dataset.trials.size());
  provenance.exclusions = dataset.exclusions;
  return provenance;
}

std::string provenance_text(const Provenance& provenance) {
  std::string text;
  if (provenance.stored_trials) {
    text += fmt::format("Trials: {} in the data, {} analysed",
                        *provenance.stored_trials,
                        provenance.analysed_trials);
    bool first = true;
    for (const auto& [reason, trials] : provenance.exclusions) {
      if (trials == 0) continue;
      text += fmt::format("{}{} x {}", first ? "; left out: " : ", ", trials, reason);
      first = false;
    }
    text += ".\n";
  }
  if (provenance.seed && provenance.resamples) {
    text += fmt::format(
        "Drawn at random: {} times, seed {}.\n", *provenance.resamples, *provenance.seed);
  }
  return text;
}

nlohmann::ordered_json provenance_json(const Provenance& provenance) {
  using Json = nlohmann::ordered_json;
  Json json{{"program", provenance.program}, {"files", Json::array()}};
  for (const auto& file : provenance.files) {
    json["files"].push_back({{"name", file.name}, {"sha256", file.sha256}});
  }
  if (provenance.stored_trials) {
    json["trials"] = *provenance.stored_trials;
    json["analysed_trials"] = provenance.analysed_trials;
    json["exclusions"] = Json::array();
    for (const auto& [reason, trials] : provenance.exclusions) {
      json["exclusions"].push_back({{"reason", reason}, {"trials", trials}});
    }
  }
  if (provenance.seed) json["seed"] = *provenance.seed;
  if (provenance.resamples) json["resamples"] = *provenance.resamples;
  return json;
}

}  // namespace bimodal::analysis
