#pragma once

#include <optional>
#include <string>
#include <variant>

#include "runner/cli/verbs.hpp"
#include "stimuli/audio/band.hpp"

namespace bimodal::runner {

/// What is played and measured, as `levels play` and `levels set` take it.
struct LevelOptions {
  std::string device;  ///< as `run --audio` takes it; empty: the default
  std::string band = "80-8000";
  std::optional<double> tone_hz;
  double dbfs = -30;
  int rate_hz = 48'000;
  std::optional<int> channel;
};

/// --device, --band, --tone, --dbfs, --rate, --channel.
void add_level_options(CLI::App& verb, LevelOptions& options);

/// Throws Error if the band is none.
[[nodiscard]] std::variant<Band, Hertz> content_of(const LevelOptions& options);

/// "noise of 80-8000 Hz at -30 dB FS".
[[nodiscard]] std::string describe(const LevelOptions& options);

/// Adds the verb "play" to "levels".
void add_levels_play(CLI::App& levels, Verb& chosen);

}  // namespace bimodal::runner
