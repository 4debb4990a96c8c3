#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "protocols/observers/phone_table.hpp"
#include "stimuli/base/diagnostic.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::protocols {

/// What of a stimulus reaches the observer.
struct Presented {
  bool heard = false;
  bool seen = false;
  std::optional<Decibels> snr;  ///< of what is heard; absent: no noise
};

/// What a simulated listener confuses. Every phone has some chance of being recognised.
struct ObserverDescription {
  std::string name;
  std::string provenance;     ///< where the numbers come from; stands in whatever is made with them
  Decibels stated_snr;        ///< at which `auditory` holds
  double slope_per_db = 0.0;  ///< above 0: how fast hearing changes with the S/N
  PhoneTable auditory;        ///< confusion table by ear at stated_snr
  PhoneTable visual;          ///< confusion table by eye
};

/// The confusion table for what is presented.
///   By ear, at d dB above the stated S/N: with w = tanh(slope |d| / 2) = 2 logistic(slope |d|) -
///   1, the mixture of the stated table and, in proportion w, of recognising everything (d > 0) or
///   of perceiving nothing (d < 0). Without noise everything is recognised. By eye: the visual
///   table. By both: their fuzzy_product. By neither: uniform.
[[nodiscard]] PhoneTable confusions(const ObserverDescription& description,
                                    const Presented& presented);

/// Reads an observer file such as protocols/observers/typical.json. Appends every mistake (unknown
/// or missing phone or row, a row that does not sum to 1 within 1e-6, a phone that is never
/// recognised) to `diagnostics`; with an error among them the tables may be incomplete and must not
/// be used. Rows are scaled to sum to 1 exactly.
[[nodiscard]] ObserverDescription read_observer(const std::filesystem::path& file,
                                                std::vector<Diagnostic>& diagnostics);

}  // namespace bimodal::protocols
