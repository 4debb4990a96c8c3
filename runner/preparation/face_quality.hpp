#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "protocols/model/protocol.hpp"
#include "stimuli/base/quantity.hpp"
#include "synth/render/quality.hpp"

namespace bimodal::runner {

/// What drawing in full quality takes on this machine, and what a session leaves for it. While a
/// stimulus is presented nothing is drawn: films are drawn while people answer and rest.
struct DrawingPace {
  Duration picture{};         ///< to draw one picture of the session's costliest face
  Hertz picture_rate{60};     ///< so many pictures has a film of a second of speech
  Duration between_trials{};  ///< the protocol's pause
};

/// To draw the film of a second of speech: about that of a word; what stands still is drawn once.
[[nodiscard]] Duration film_time(const DrawingPace& pace);

/// From the end of one stimulus to the beginning of the next: 4 s for the answer (a guess) and the
/// pause.
[[nodiscard]] Duration drawing_time(const DrawingPace& pace);

/// Whether films are drawn before they are needed, also for people who answer twice as fast: a film
/// takes at most half of the time for it.
[[nodiscard]] bool keeps_ahead(const DrawingPace& pace);

/// Why a session's faces are drawn in the quality in which they are.
enum class QualityBasis : std::uint8_t {
  Protocol,   ///< it says so
  Measured,   ///< by keeps_ahead()
  Unwatched,  ///< nobody looks (no display, or simulated answers): fast, so that it is quick
};

struct ChosenQuality {
  synth::Quality quality = synth::Quality::Fast;
  QualityBasis basis = QualityBasis::Unwatched;
  std::optional<DrawingPace> pace;  ///< of full quality; absent: not measured
};

/// Whether the pace matters to what is chosen, or to what is to be expected of it.
[[nodiscard]] bool must_be_measured(protocols::FaceQuality wanted, bool watched);

/// The quality of a session. `pace` is absent if it has not been measured.
[[nodiscard]] ChosenQuality choose_quality(protocols::FaceQuality wanted,
                                           const std::optional<DrawingPace>& pace);

/// Whether people would wait for films between trials: what was chosen does not keep ahead.
[[nodiscard]] bool draws_too_slowly(const ChosenQuality& chosen);

/// "fast", "full".
[[nodiscard]] std::string_view name(synth::Quality quality);

/// "protocol", "measured", "unwatched".
[[nodiscard]] std::string_view name(QualityBasis basis);

/// What was chosen, why, and what to expect, as a sentence for the experimenter.
[[nodiscard]] std::string describe(const ChosenQuality& chosen);

}  // namespace bimodal::runner
