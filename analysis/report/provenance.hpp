#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/data/dataset.hpp"

namespace bimodal::analysis {

/// Where figures came from: what everybody needs who wants to make them again.
struct Provenance {
  std::string program;                        ///< "bimodal-analysis 0.1.0"
  std::vector<SourceFile> files;              ///< that were read
  std::optional<std::int64_t> stored_trials;  ///< absent: a table of counts, which has no trials
  std::int64_t analysed_trials = 0;
  std::vector<Exclusion> exclusions;
  std::optional<std::uint64_t> seed;      ///< absent: nothing was drawn at random
  std::optional<std::int64_t> resamples;  ///< absent: nothing was drawn at random
};

/// Of trials; `program` is the program's name and version.
[[nodiscard]] Provenance provenance_of(const Dataset& dataset, std::string program);

/// "Trials: 400 stored, 380 analysed; left out: 20 x practice trial." and what was drawn at random;
/// a line each, none that has nothing to say.
[[nodiscard]] std::string provenance_text(const Provenance& provenance);

[[nodiscard]] nlohmann::ordered_json provenance_json(const Provenance& provenance);

}  // namespace bimodal::analysis
