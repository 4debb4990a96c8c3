#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "stimuli/audio/clip.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

/// What is measured of one take: a word that somebody has just spoken.
struct TakeMeasures {
  Duration duration{};
  std::optional<SpeechInterval> speech;  ///< absent: nobody spoke
  Decibels level;                        ///< RMS of the speech, dB re full scale (an RMS of 1)
  Decibels peak;                         ///< of the whole take: 0 dB is the largest sample there is
  Decibels snr;             ///< of the speech without rumble, above the room without rumble
  std::size_t clipped = 0;  ///< samples at full scale (at least 0.999 of it)
};

/// `room` is the room_level() of the same device. Without speech, level and snr are those of the
/// whole take; of silence they are -infinity.
[[nodiscard]] TakeMeasures measure_take(const Clip& take, Decibels room);

/// Why a take should be spoken again, the most urgent first.
enum class TakeFault {
  Nothing,     ///< nobody spoke
  Gaps,        ///< the device lost samples
  Clipped,     ///< at least one sample at full scale
  Quiet,       ///< the peak is too low
  Noisy,       ///< too little above the room
  BegunEarly,  ///< speech where the take begins
  CutOff,      ///< speech where the take ends
};

/// "nothing", "gaps", "clipped", "quiet", "noisy", "begun_early", "cut_off": how it is stored.
[[nodiscard]] std::string_view name(TakeFault fault);

/// The inverse of name(); absent for any other text.
[[nodiscard]] std::optional<TakeFault> take_fault(std::string_view name);

/// What a talker should do about it: "Too loud: move back a little, or speak more softly."
[[nodiscard]] std::string_view advice(TakeFault fault);

struct TakeRules {
  Decibels lowest_peak{-30.0};
  Decibels lowest_snr{20.0};
  Duration margin = std::chrono::milliseconds{100};  ///< without speech at either end
};

/// All faults of a take, in the order of TakeFault; none: it is good. `lost` counts the samples
/// that the device lost within it. Of a take without speech only Nothing and Gaps are told.
[[nodiscard]] std::vector<TakeFault> faults_of(const TakeMeasures& measures,
                                               std::int64_t lost,
                                               const TakeRules& rules = {});

}  // namespace bimodal
