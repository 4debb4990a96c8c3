#pragma once

#include <nlohmann/json.hpp>

#include "runner/timing/moments.hpp"
#include "runner/timing/start_up_gate.hpp"

namespace bimodal::runner {

/// The verdict on a screen, its reasons and what was measured, as it is stored and exported.
[[nodiscard]] nlohmann::ordered_json as_json(const Gate& gate);

/// How durations are distributed, in milliseconds.
[[nodiscard]] nlohmann::ordered_json as_json(const Moments& moments);

}  // namespace bimodal::runner
