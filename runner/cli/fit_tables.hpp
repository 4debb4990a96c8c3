#pragma once

#include <string>
#include <vector>

#include "runner/cli/labelled_track.hpp"
#include "synth/fitting/leave_one_out.hpp"

namespace bimodal::runner {

/// All that there is to say of the fit of one measure.
struct FitReport {
  std::string column;
  bool relative = false;  ///< targets are relative to the talker's mean over the speech
  std::vector<synth::MeasuredClip> clips;
  synth::FitOptions options;
  synth::Fit fit;
  std::vector<synth::Agreement> fitted;    ///< per clip
  std::vector<synth::Agreement> left_out;  ///< per clip; empty if none was left out
};

[[nodiscard]] std::vector<std::string> column_names(const LabelledTrack& recording);

[[nodiscard]] FitReport report_of(const std::string& column,
                                  std::vector<synth::MeasuredClip> clips,
                                  synth::Chosen chosen,
                                  synth::Fit fit);

/// "6 clips, 266 instants; shrinkage 0.5; fitted RMSE 1.73, r 0.91; left-out RMSE 2.92, scaled
/// 2.27, r 0.85".
[[nodiscard]] std::string summary(const FitReport& report);

/// Prints the summary, a table of the parts and one of the clips.
void print_fit(const FitReport& report);

}  // namespace bimodal::runner
