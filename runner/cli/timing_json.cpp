#include "runner/cli/timing_json.hpp"

namespace bimodal::runner {

nlohmann::ordered_json as_json(const Gate& gate) {
  return {{"verdict", name(gate.verdict)},
          {"reasons", gate.reasons},
          {"flips", gate.flips},
          {"period_ns", gate.period.count()},
          {"sd_ns", gate.deviation.count()},
          {"longest_ns", gate.longest.count()},
          {"outliers", gate.outliers}};
}

nlohmann::ordered_json as_json(const Moments& moments) {
  return {{"trials", moments.count},
          {"mean_ms", moments.mean_ms},
          {"sd_ms", moments.deviation_ms},
          {"median_ms", moments.median_ms},
          {"smallest_ms", moments.smallest_ms},
          {"largest_ms", moments.largest_ms}};
}

}  // namespace bimodal::runner
