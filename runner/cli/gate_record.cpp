#include "runner/cli/gate_record.hpp"

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

}  // namespace bimodal::runner
