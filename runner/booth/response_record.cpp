#include "runner/booth/response_record.hpp"

#include <algorithm>

namespace bimodal::runner {

namespace {

using protocols::RtFrom;

/// When the modality's onset was; null: the trial has none.
const OnsetRecord* onset_of(RtFrom from, const TrialRecord& trial) {
  if (from == RtFrom::End) return nullptr;
  const auto* const modality = from == RtFrom::SoundOnset ? "auditory" : "visual";
  const auto found = std::ranges::find(trial.onsets, modality, &OnsetRecord::modality);
  return found == trial.onsets.end() ? nullptr : &*found;
}

}  // namespace

ResponseRecord response_record(const RecordResponse& response,
                               RtFrom from,
                               const TrialRecord& trial) {
  ResponseRecord record{.text = response.text,
                        .submitted = response.submitted.time_since_epoch(),
                        .timed_out = response.timed_out,
                        .uncertainty = response.uncertainty};
  if (response.first_key) record.first_key = response.first_key->time_since_epoch();
  const auto* const onset = onset_of(from, trial);
  record.reference = name(onset == nullptr ? RtFrom::End : from);
  record.reference_at =
      onset == nullptr ? trial.stimulus_end : onset->reported.value_or(onset->planned);
  return record;
}

}  // namespace bimodal::runner
