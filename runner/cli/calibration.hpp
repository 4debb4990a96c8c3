#pragma once

#include <filesystem>
#include <string>

#include "runner/timing/moments.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// What instruments found about one screen and one sound output, under a name.
struct Calibration {
  std::string name;
  std::string made_utc;
  std::string display;  ///< as its device describes itself
  std::string audio;
  std::string input;
  Moments offset;    ///< true audio-visual offset, where 0 was intended
  Moments visual;    ///< true minus reported visual onset
  Moments auditory;  ///< true minus reported auditory onset
};

/// The part of a description that names the device and not the day's measurements: up to the first
/// ", period " or ", stream of ".
[[nodiscard]] std::string device_part(const std::string& description);

/// `name` in the folder of calibrations, `$BIMODAL_CONFIG/timing` or `~/.config/bimodal/timing`;
/// a name with a `/` is a file of its own.
[[nodiscard]] std::filesystem::path calibration_file(const std::string& name);

/// One JSON object, made readable only for its owner. Throws Error.
void write_calibration(const Calibration& calibration, const std::filesystem::path& file);

/// Throws Error, naming the file, what is wrong with it and what to do.
[[nodiscard]] Calibration read_calibration(const std::filesystem::path& file);

/// As it is stored with a session.
[[nodiscard]] std::string as_text(const Calibration& calibration);

}  // namespace bimodal::runner
