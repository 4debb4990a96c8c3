#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/data/feature_file.hpp"
#include "analysis/statistics/information.hpp"
#include "analysis/statistics/transmission_interval.hpp"

namespace bimodal::analysis {

/// How much of one feature came through.
struct FeatureInformation {
  std::string feature;
  double left_out = 0.0;  ///< responses whose label has no value of it ("blank", say)
  std::optional<Information> information;            ///< absent if all are left out
  std::optional<JackknifedTransmission> jackknifed;  ///< absent of parts of responses
  std::optional<TransmissionInterval> interval;      ///< absent if none was asked for
};

/// How much of the stimuli of one matrix came through, and of each of their features.
struct InformationTable {
  std::string title;
  std::size_t stimuli = 0;  ///< that were presented
  Information whole;
  std::optional<JackknifedTransmission> jackknifed;  ///< absent of parts of responses
  std::optional<TransmissionInterval> interval;      ///< absent if none was asked for
  std::string why_no_intervals;                      ///< where none was asked for
  std::vector<FeatureInformation> features;
};

/// Intervals of what was transmitted, or why there shall be none.
struct IntervalRequest {
  std::optional<Seed> seed;  ///< absent: none
  std::int64_t draws = kTransmissionDraws;
  std::string why_none;
};

/// The matrix has responses. Throws Error if a stimulus that was presented is not in the table of
/// features.
[[nodiscard]] InformationTable tabulate_information(std::string title,
                                                    const ConfusionMatrix& matrix,
                                                    const FeatureTable& features = {},
                                                    const IntervalRequest& intervals = {});

/// For people: two or three decimals, what the numbers mean, and how far to trust them.
[[nodiscard]] std::string information_text(const InformationTable& table);

/// Every figure in full precision: a line for the whole and one for each feature.
[[nodiscard]] std::string information_csv(const InformationTable& table);

/// The same as JSON.
[[nodiscard]] std::string information_json(const InformationTable& table);

}  // namespace bimodal::analysis
