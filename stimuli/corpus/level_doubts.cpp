#include "stimuli/corpus/level_doubts.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace bimodal {

namespace {

constexpr double kLevelRange = 12.0;
constexpr double kRunningRange = 30.0;

/// In dB, by talker.
std::map<std::string, double> median_levels(std::span<const BuiltRecording> recordings) {
  std::map<std::string, std::vector<double>> of_talkers;
  for (const auto& built : recordings) {
    for (const auto level : built.levels) {
      if (std::isfinite(level.count())) {
        of_talkers[built.recording.talker].push_back(level.count());
      }
    }
  }
  std::map<std::string, double> medians;
  for (auto& [talker, levels] : of_talkers) {
    const auto middle = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 2);
    std::ranges::nth_element(levels, middle);
    medians[talker] = *middle;
  }
  return medians;
}

}  // namespace

void doubt_levels(std::span<BuiltRecording> recordings) {
  const auto medians = median_levels(recordings);
  for (auto& built : recordings) {
    const auto median = medians.find(built.recording.talker);
    if (median == medians.end()) continue;
    const double range = built.running ? kRunningRange : kLevelRange;
    for (std::size_t i = 0; i < built.items.size(); ++i) {
      const double difference = built.levels[i].count() - median->second;
      if (std::abs(difference) <= range) continue;
      auto& doubt = built.items[i].doubt;
      doubt += fmt::format("{}it is {:.0f} dB {} than the talker's other words",
                           doubt.empty() ? "" : "; ",
                           std::abs(difference),
                           difference > 0 ? "louder" : "weaker");
    }
  }
}

}  // namespace bimodal
