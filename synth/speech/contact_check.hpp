#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "synth/speech/segment_table.hpp"

namespace bimodal::synth {

/// One picture of a 60 Hz display: what lasts as long is shown, whatever the display's phase.
inline constexpr Milliseconds kShownPicture{1000.0 / 60};

/// A contact that an inventory makes too briefly to be seen.
struct MissedContact {
  std::string context;  ///< "K AA B"
  Phone phone = Phone::Rest;
  double rate = 1;
  Milliseconds longest{};  ///< unbroken contact; 0 if there is none
};

struct ContactReport {
  std::size_t contexts = 0;
  Milliseconds briefest{};  ///< over all contexts
  std::vector<MissedContact> missed;
};

/// Whether the lips close (lip_closure reaches 1) for P B M, and the lower lip meets the teeth
/// (lower_lip_tuck reaches 1) for F V, for at least kShownPicture at a stretch: in every syllable C
/// V C of all consonants and vowels that has one of these at either end, with intrinsic durations
/// at each speaking rate, between pauses. `progress`, where given, is told the part done.
[[nodiscard]] ContactReport check_contacts(
    const SegmentTable& table,
    std::span<const double> rates,
    const std::function<void(double part_done)>& progress = {});

}  // namespace bimodal::synth
