#pragma once

namespace bimodal {

/// A protocol whose trials are over soon.
inline constexpr const char* kSixWords = R"({
  "bimodal_protocol": 1,
  "title": "Six words in haste",
  "seed": 3,
  "words": ["cat", "fish", "moon", "stew", "tree", "house"],
  "conditions": [
    {"name": "voice", "auditory": {"talker": "festival:kal"}, "snr_db": 0}
  ],
  "intervals": {"fixation_s": 0.05, "lead_s": 0.05, "trail_s": 0.05, "pause_s": 0.05}
}
)";

}  // namespace bimodal
