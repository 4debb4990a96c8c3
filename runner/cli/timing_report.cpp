#include "runner/cli/timing_report.hpp"

#include <algorithm>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runner/cli/timing_json.hpp"
#include "stimuli/base/milliseconds.hpp"

namespace bimodal::runner {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kUnknown =
    "What cannot be known without instruments: when light left the screen and sound left the\n"
    "loudspeaker. The instants above are the computer's own word. A screen may show a picture 1 to "
    "50\n"
    "ms later (scan-out, processing, the panel), a sound device some ms later than it says, and a\n"
    "program can log perfect timing while the screen stands still. Put a photodiode on the left "
    "half\n"
    "of the flash and a cable from the sound output, both on a sound input, and run\n"
    "  bimodal timing --input DEVICE --calibration NAME\n";

Json as_json(const std::optional<Duration>& at) {
  return at ? Json(at->count()) : Json();
}

/// Null where nothing was measured.
Json moments_or_null(const Moments& moments) {
  return moments.count == 0 ? Json() : as_json(moments);
}

Json as_json(const TimedTrial& trial) {
  const auto& record = trial.record;
  Json json{{"trial", record.trial},
            {"flagged", record.flagged},
            {"visual_ns", as_json(trial.visual)},
            {"auditory_ns", as_json(trial.auditory)},
            {"measured_visual_ns", as_json(trial.true_visual)},
            {"measured_auditory_ns", as_json(trial.true_auditory)},
            {"events", Json::array()},
            {"frames", record.refreshes.frame},
            {"shown_ns", Json::array()}};
  for (const auto& onset : record.onsets) {
    json["planned_ns"][onset.modality] = onset.planned.count();
    json["source"][onset.modality] = onset.source;
  }
  for (const auto& event : record.events)
    json["events"].push_back(event.kind + ": " + event.detail);
  for (const auto shown : record.refreshes.shown) json["shown_ns"].push_back(shown.count());
  return json;
}

std::string line(const char* what, const Moments& moments) {
  if (moments.count == 0) return {};
  return fmt::format("  {:<36} mean {:+8.3f} ms  SD {:6.3f}  from {:+.3f} to {:+.3f}\n",
                     what,
                     moments.mean_ms,
                     moments.deviation_ms,
                     moments.smallest_ms,
                     moments.largest_ms);
}

std::string verdict_text(const Gate& gate) {
  auto text = fmt::format("verdict on the screen: {}", name(gate.verdict));
  if (!gate.reasons.empty()) text += fmt::format(" ({})", fmt::join(gate.reasons, "; "));
  return text + "\n";
}

}  // namespace

TimingSummary summarise(const TimingFindings& findings) {
  TimingSummary summary;
  std::vector<Duration> reported;
  std::vector<Duration> measured;
  std::vector<Duration> visual;
  std::vector<Duration> auditory;
  for (const auto& trial : std::span{findings.trials}.subspan(
           std::min<std::size_t>(1, findings.trials.size()))) {  // the first one finds caches cold
    ++summary.trials;
    if (trial.record.flagged) {
      ++summary.flagged;
      continue;
    }
    if (!trial.visual || !trial.auditory) continue;
    reported.push_back(*trial.auditory - *trial.visual - findings.intended);
    if (findings.input.empty()) continue;
    if (!trial.true_visual || !trial.true_auditory) {
      ++summary.unmeasured;
      continue;
    }
    measured.push_back(*trial.true_auditory - *trial.true_visual - findings.intended);
    visual.push_back(*trial.true_visual - *trial.visual);
    auditory.push_back(*trial.true_auditory - *trial.auditory);
  }
  summary.reported = moments_of(reported);
  summary.measured = moments_of(measured);
  summary.visual = moments_of(visual);
  summary.auditory = moments_of(auditory);
  summary.offsets = findings.input.empty() ? std::move(reported) : std::move(measured);
  return summary;
}

std::string as_text(const TimingFindings& findings) {
  const auto summary = summarise(findings);
  const bool has_instruments = !findings.input.empty();
  auto text = fmt::format("screen: {}\nsound:  {}\n", findings.display, findings.audio);
  if (has_instruments) text += fmt::format("input:  {}\n", findings.input);
  text += fmt::format("{}\n{}\n", findings.right_of_way, verdict_text(findings.gate));
  text += fmt::format(
      "{} trials after the first, {} flagged; audio-visual offset (audio minus "
      "visual, {:+g} ms intended) of the others:\n",
      summary.trials,
      summary.flagged,
      milliseconds(findings.intended));
  text += line("reported, off the intended one", summary.reported);
  text += line("measured, off the intended one", summary.measured);
  text += line("light, measured minus reported", summary.visual);
  text += line("sound, measured minus reported", summary.auditory);
  if (summary.unmeasured > 0) {
    text += fmt::format(
        "  in {} trials the instruments saw or heard nothing: is the photodiode on "
        "the left half of the flash, and is the cable in channel and level right?\n",
        summary.unmeasured);
  }
  if (findings.input_lost > 0) {
    text += fmt::format("  {} samples of the input were lost: what it measured is wrong\n",
                        findings.input_lost);
  }
  text += fmt::format("\n{} offset, off the intended one:\n{}",
                      has_instruments ? "measured" : "reported",
                      draw(histogram_of(summary.offsets)));
  for (const auto& trial : findings.trials) {
    for (const auto& event : trial.record.events) {
      text += fmt::format(
          "trial {} flagged: {}: {}\n", trial.record.trial + 1, event.kind, event.detail);
    }
  }
  if (!has_instruments) text += std::string{"\n"} + kUnknown;
  return text;
}

std::string as_json(const TimingFindings& findings) {
  const auto summary = summarise(findings);
  Json json{{"bimodal_timing", 1},
            {"made_utc", findings.made_utc},
            {"display", findings.display},
            {"audio", findings.audio},
            {"input", findings.input},
            {"input_lost_samples", findings.input_lost},
            {"right_of_way", findings.right_of_way},
            {"gate", as_json(findings.gate)},
            {"intended_offset_ns", findings.intended.count()},
            {"summary",
             {{"trials_after_the_first", summary.trials},
              {"flagged", summary.flagged},
              {"reported_offset", moments_or_null(summary.reported)},
              {"measured_offset", moments_or_null(summary.measured)},
              {"visual_measured_minus_reported", moments_or_null(summary.visual)},
              {"auditory_measured_minus_reported", moments_or_null(summary.auditory)}}},
            {"trials", Json::array()}};
  for (const auto& trial : findings.trials) json["trials"].push_back(as_json(trial));
  return json.dump(1) + "\n";
}

}  // namespace bimodal::runner
