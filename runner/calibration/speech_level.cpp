#include "runner/calibration/speech_level.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bimodal::runner {

namespace {

/// What 0 dB re full scale would be.
double offset_of(const MeasuredLevel& level) {
  return level.dbspl.count() - level.dbfs.count();
}

/// What the device has been measured with at this rate: "noise of 100-4000 Hz, a tone of 1000 Hz".
std::string described(const std::vector<MeasuredLevel>& levels) {
  std::vector<std::string> kinds;
  for (const auto& level : levels) {
    kinds.push_back(level.low_hz == level.high_hz
                        ? fmt::format("a tone of {:g} Hz", level.low_hz)
                        : fmt::format("noise of {:g}-{:g} Hz", level.low_hz, level.high_hz));
    if (level.channel) kinds.back() += fmt::format(" on channel {}", *level.channel);
  }
  return fmt::format("{}", fmt::join(kinds, ", "));
}

}  // namespace

DecibelsSpl SpeechCalibration::spl_at(Decibels level) const {
  return DecibelsSpl{offset_of(measured.front()) + level.count()};
}

Decibels SpeechCalibration::level_for(DecibelsSpl wanted) const {
  return Decibels{wanted.count() - offset_of(measured.front())};
}

std::variant<SpeechCalibration, NotCalibrated> calibration_for(const LevelTable& table,
                                                               const Listening& listening) {
  const auto known = table.of(listening.device, listening.rate_hz);
  std::vector<MeasuredLevel> fitting;
  std::ranges::copy_if(known, std::back_inserter(fitting), [&](const MeasuredLevel& level) {
    return level.low_hz == listening.low_hz && level.high_hz == listening.high_hz;
  });
  const auto channels = listening.channels.empty() ? std::vector{1, 2} : listening.channels;
  const bool both_ears = std::ranges::all_of(channels, [](int channel) { return channel <= 2; });
  SpeechCalibration calibration;
  for (const int channel : channels) {
    const auto own = std::ranges::find(fitting, std::optional{channel}, &MeasuredLevel::channel);
    const auto together = std::ranges::find(fitting, std::optional<int>{}, &MeasuredLevel::channel);
    if (own != fitting.end()) {
      calibration.measured.push_back(*own);
    } else if (both_ears && together != fitting.end()) {
      calibration.measured.push_back(*together);
    } else {
      return NotCalibrated{fmt::format(
          "the level of noise of {:g}-{:g} Hz on channel {} of '{}' at {} samples per second has "
          "not been measured{}",
          listening.low_hz,
          listening.high_hz,
          channel,
          listening.device,
          listening.rate_hz,
          known.empty() ? "" : fmt::format(" (but {} has)", described(known)))};
    }
  }
  const auto [lowest, highest] = std::ranges::minmax(calibration.measured, {}, offset_of);
  calibration.spread = Decibels{offset_of(highest) - offset_of(lowest)};
  return calibration;
}

std::string calibration_remedy(const Listening& listening) {
  return fmt::format(
      "measure it: bimodal levels play --device '{0}' --band {1:g}-{2:g} --rate {3} --dbfs -30, "
      "then bimodal levels set with the same options and --dbspl",
      listening.device,
      listening.low_hz,
      listening.high_hz,
      listening.rate_hz);
}

}  // namespace bimodal::runner
