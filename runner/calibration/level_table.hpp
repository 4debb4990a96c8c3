#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stimuli/base/diagnostic.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// What was measured at the ear (or the listener's place) while a sound output played noise of one
/// band, or a tone. It holds for the same device, rate and band, and as long as no knob is turned
/// and nothing in the way is exchanged.
struct MeasuredLevel {
  std::string device;          ///< "system (JACK Audio Connection Kit)"
  int rate_hz = 48'000;        ///< of the stream
  double low_hz = 80;          ///< band of the noise;
  double high_hz = 8'000;      ///< of a tone, its frequency, both
  std::optional<int> channel;  ///< from 1, the only one that played; absent: both ears
  Decibels dbfs{-30};          ///< RMS of what was played, re full scale
  DecibelsSpl dbspl{};         ///< and what was measured then
  std::string date;            ///< "2026-01-31"
  std::string instrument;
  std::string note;
};

/// What distinguishes measurements: one replaces another of the same place.
[[nodiscard]] bool same_place(const MeasuredLevel& one, const MeasuredLevel& other);

/// Measured levels of this machine's sound outputs, kept in a JSON file.
class LevelTable {
 public:
  LevelTable() = default;

  explicit LevelTable(std::vector<MeasuredLevel> levels) : levels_{std::move(levels)} {}

  [[nodiscard]] const std::vector<MeasuredLevel>& levels() const { return levels_; }

  /// Replaces what is there for the same place, which is returned; else adds.
  std::optional<MeasuredLevel> put(MeasuredLevel level);

  /// Those of a device at a rate, whatever was played.
  [[nodiscard]] std::vector<MeasuredLevel> of(std::string_view device, int rate_hz) const;

  /// As JSON, the content of a file.
  [[nodiscard]] std::string text() const;

 private:
  std::vector<MeasuredLevel> levels_;
};

/// Reads a table and judges it whole; `file` is its name in diagnostics. Absent: it has errors.
[[nodiscard]] std::optional<LevelTable> read_levels_text(std::string_view text,
                                                         std::string_view file,
                                                         std::vector<Diagnostic>& diagnostics);

/// $BIMODAL_LEVELS, else levels.json in $XDG_CONFIG_HOME/bimodal or ~/.config/bimodal.
[[nodiscard]] std::filesystem::path level_file();

/// The table of a file; an empty one if there is no such file. Throws Error, naming file, line and
/// remedy, if it cannot be used.
[[nodiscard]] LevelTable read_levels(const std::filesystem::path& file);

/// Makes the folder if need be. Throws Error if the file cannot be written.
void write_levels(const std::filesystem::path& file, const LevelTable& table);

}  // namespace bimodal::runner
