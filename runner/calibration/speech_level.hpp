#pragma once

#include <string>
#include <variant>
#include <vector>

#include "runner/calibration/level_table.hpp"

namespace bimodal::runner {

/// Where speech is to be heard.
struct Listening {
  std::string device;  ///< as MeasuredLevel::device
  int rate_hz = 48'000;
  double low_hz = 80;  ///< the band in which the level of the speech is measured
  double high_hz = 8'000;
  std::vector<int> channels;  ///< from 1; none: both ears
};

/// How levels re full scale and sound pressure levels go together there: each dB of one is a dB of
/// the other.
struct SpeechCalibration {
  /// What was measured on each channel (or on both ears at once), in the order of the channels.
  std::vector<MeasuredLevel> measured;
  /// By how much the channels differ, at most; 0 for one measurement.
  Decibels spread{0};

  /// SPL at `level`: measured SPL + (level - measured dB FS), on the first channel.
  [[nodiscard]] DecibelsSpl spl_at(Decibels level) const;

  /// The inverse: wanted SPL - (measured SPL - measured dB FS).
  [[nodiscard]] Decibels level_for(DecibelsSpl wanted) const;
};

/// Why there is none: what is missing, and what else there is.
struct NotCalibrated {
  std::string finding;
};

/// The calibration for noise of the very band, at the very rate, of all channels: each by itself,
/// else as both ears together.
[[nodiscard]] std::variant<SpeechCalibration, NotCalibrated> calibration_for(
    const LevelTable& table, const Listening& listening);

/// How to get one: "measure it: bimodal levels play ..., then bimodal levels set ...".
[[nodiscard]] std::string calibration_remedy(const Listening& listening);

}  // namespace bimodal::runner
