#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runner/cli/lip_comparison.hpp"

namespace bimodal::runner {

/// The measures that any clip has, in their order.
[[nodiscard]] std::vector<std::string> measures_of(std::span<const ClipComparison> clips);

/// nullptr if the clip does not have the measure.
[[nodiscard]] const MeasureComparison* comparison_of(const ClipComparison& clip,
                                                     const std::string& measure);

[[nodiscard]] synth::Agreement over_clips(std::span<const ClipComparison> clips,
                                          const std::string& measure);

/// When something happens to the lips, counted in ms from an instant of its phone.
struct MomentSummary {
  std::string_view phones;   ///< "P B M"
  std::string_view measure;  ///< "inner_h"
  std::string_view moment;   ///< "lowest, from the centre"
  synth::Middle measured;
  synth::Middle predicted;
  synth::Middle difference;  ///< predicted minus measured, where there are both
};

/// The lowest inner height in closures; half of the fall of the outer width, and its least, in
/// roundings.
[[nodiscard]] std::vector<MomentSummary> moments_of(std::span<const ClipComparison> clips);

/// How many lips shut (below kShutMm); of how many phones that close them.
struct Closed {
  std::size_t tokens = 0;
  std::size_t measured = 0;
  std::size_t predicted = 0;
};

[[nodiscard]] Closed closed_of(std::span<const ClipComparison> clips);

/// Of the tokens of a phone, at their centres.
struct PhoneMean {
  std::size_t count = 0;
  double measured = 0;
  double predicted = 0;
};

[[nodiscard]] std::map<Phone, PhoneMean> phone_means(std::span<const ClipComparison> clips,
                                                     const std::string& measure);

}  // namespace bimodal::runner
