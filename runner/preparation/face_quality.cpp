#include "runner/preparation/face_quality.hpp"

#include <chrono>

#include <fmt/format.h>

#include "stimuli/base/milliseconds.hpp"

namespace bimodal::runner {

namespace {

/// From the end of a stimulus to Enter, as `bimodal check` estimates it.
constexpr Duration kAnswer = std::chrono::seconds{4};

constexpr double kSpeechSeconds = 1.0;  ///< of a film

double seconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

/// "a picture takes 120 ms, the film of a word about 7.2 s"
std::string costs(const DrawingPace& pace, std::string_view takes) {
  return fmt::format("a picture {} {:.1f} ms, the film of a word about {:.1f} s",
                     takes,
                     milliseconds(pace.picture),
                     seconds(film_time(pace)));
}

std::string time_for_it(const DrawingPace& pace) {
  return fmt::format("half of the {:.1f} s between stimuli", seconds(drawing_time(pace)));
}

}  // namespace

Duration film_time(const DrawingPace& pace) {
  return std::chrono::duration_cast<Duration>(pace.picture * pace.picture_rate.count() *
                                              kSpeechSeconds);
}

Duration drawing_time(const DrawingPace& pace) {
  return kAnswer + pace.between_trials;
}

bool keeps_ahead(const DrawingPace& pace) {
  return 2 * film_time(pace) <= drawing_time(pace);
}

bool must_be_measured(protocols::FaceQuality wanted, bool watched) {
  return watched && wanted != protocols::FaceQuality::Fast;
}

ChosenQuality choose_quality(protocols::FaceQuality wanted,
                             const std::optional<DrawingPace>& pace) {
  using synth::Quality;
  switch (wanted) {
    case protocols::FaceQuality::Fast:
      return {Quality::Fast, QualityBasis::Protocol, pace};
    case protocols::FaceQuality::Full:
      return {Quality::Full, QualityBasis::Protocol, pace};
    case protocols::FaceQuality::Auto:
      break;
  }
  if (!pace) return {Quality::Fast, QualityBasis::Unwatched, std::nullopt};
  return {keeps_ahead(*pace) ? Quality::Full : Quality::Fast, QualityBasis::Measured, pace};
}

bool draws_too_slowly(const ChosenQuality& chosen) {
  return chosen.quality == synth::Quality::Full && chosen.pace && !keeps_ahead(*chosen.pace);
}

std::string_view name(synth::Quality quality) {
  return quality == synth::Quality::Full ? "full" : "fast";
}

std::string_view name(QualityBasis basis) {
  switch (basis) {
    case QualityBasis::Protocol:
      return "protocol";
    case QualityBasis::Measured:
      return "measured";
    case QualityBasis::Unwatched:
      return "unwatched";
  }
  return "unknown";
}

std::string describe(const ChosenQuality& chosen) {
  auto text = fmt::format("the face is drawn in {} quality", name(chosen.quality));
  if (chosen.basis == QualityBasis::Unwatched) return text + ": nobody looks at it";
  if (chosen.basis == QualityBasis::Protocol) text += ", as the protocol says";
  if (!chosen.pace) return text;
  const auto& pace = *chosen.pace;
  if (chosen.quality == synth::Quality::Fast) {
    return fmt::format(
        "{}: in full quality {}, more than {}", text, costs(pace, "takes"), time_for_it(pace));
  }
  return fmt::format("{}: {}, {} {}",
                     text,
                     costs(pace, "takes"),
                     keeps_ahead(pace) ? "within" : "more than",
                     time_for_it(pace));
}

}  // namespace bimodal::runner
