#include "protocols/reading/meaning.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "protocols/model/talker.hpp"
#include "protocols/reading/judge_response.hpp"
#include "protocols/reading/judge_timing.hpp"
#include "protocols/reading/judge_triggers.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/json_text.hpp"
#include "stimuli/base/milliseconds.hpp"

namespace bimodal::protocols {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kManyTrials = 200;  ///< about a quarter of an hour without a break
constexpr Duration kLargeAvOffset = 200ms;
constexpr double kFaceAspect = 8.0 / 9.0;  ///< width to height of the face's picture

bool any_faulty(const Findings& findings, std::initializer_list<std::string_view> pointers) {
  return std::ranges::any_of(pointers,
                             [&](std::string_view pointer) { return findings.faulty(pointer); });
}

void judge_band(const Protocol& protocol, Findings& findings) {
  if (any_faulty(findings, {"/sound/rate_hz", "/sound/noise/band_hz"})) return;
  const double nyquist = protocol.sound.rate.count() / 2;
  const double high = protocol.sound.noise.band_high.count();
  if (high <= nyquist) return;
  findings.error(
      "/sound/noise/band_hz",
      fmt::format("the upper edge, {} Hz, is above half the sampling rate, {} Hz", high, nyquist),
      "raise \"rate_hz\" or lower the edge");
}

void judge_ramps(const Protocol& protocol, Findings& findings) {
  const bool noisy = std::ranges::any_of(
      protocol.conditions, [](const Condition& condition) { return condition.snr.has_value(); });
  const auto& noise = protocol.sound.noise;
  const Duration shortest = std::min(noise.lead, noise.trail);
  if (!noisy || findings.faulty("/sound/noise") || noise.ramp <= shortest) return;
  findings.error("/sound/noise/ramp_ms",
                 fmt::format("ramps of {} ms are longer than the noise before or after the speech, "
                             "{} ms, so the speech would meet noise that is still rising",
                             milliseconds(noise.ramp),
                             milliseconds(shortest)),
                 "shorten the ramps, or lengthen \"lead_s\" and \"trail_s\" of the noise");
}

void judge_intervals(const Protocol& protocol, Findings& findings) {
  const Duration offset = protocol.intervals.av_offset;
  if (offset > kLargeAvOffset || offset < -kLargeAvOffset) {
    findings.warning("/intervals/av_offset_ms",
                     fmt::format("sound and face are {} ms apart: most people notice it",
                                 milliseconds(std::chrono::abs(offset))),
                     "if that is meant, never mind");
  }
}

void judge_window(const Protocol& protocol, Findings& findings) {
  const bool seen = std::ranges::any_of(protocol.conditions, [](const Condition& condition) {
    return condition.visual_talker.has_value();
  });
  const auto& window = protocol.window;
  if (!seen || any_faulty(findings, {"/window/width", "/window/height", "/window/face_height"})) {
    return;
  }
  if (window.face_height > window.height) {
    findings.error("/window/face_height",
                   fmt::format("the face, {} pixels high, is higher than the window, {} pixels",
                               window.face_height,
                               window.height),
                   "lower it, or enlarge the window");
  }
  const double face_width = window.face_height * kFaceAspect;
  if (face_width > window.width) {
    findings.error(
        "/window/face_height",
        fmt::format("the face, {:.0f} pixels wide (8/9 of its height), is wider than the "
                    "window, {} pixels",
                    face_width,
                    window.width),
        "lower it, or enlarge the window");
  }
}

void judge_face(const Protocol& protocol, Findings& findings) {
  if (protocol.face == Face{} || findings.faulty("/conditions")) return;
  const bool seen = std::ranges::any_of(protocol.conditions, [](const Condition& condition) {
    return condition.visual_talker && !is_corpus(*condition.visual_talker);
  });
  if (seen) return;
  findings.warning("/face",
                   "no condition shows the synthetic face",
                   "remove it, or let \"face\" be seen in some condition");
}

void judge_breaks(const Protocol& protocol, std::size_t trials, Findings& findings) {
  if (findings.faulty("/breaks")) return;
  const auto every = static_cast<std::size_t>(protocol.breaks.every_trials);
  if (std::min(every == 0 ? trials : every, trials) > kManyTrials) {
    findings.warning(
        every == 0 ? "" : "/breaks/every_trials",
        fmt::format("{} trials without a break", std::min(every == 0 ? trials : every, trials)),
        "people tire: add \"breaks\": { \"every_trials\": 100, \"text\": ... }");
  } else if (every >= trials) {
    findings.warning("/breaks/every_trials",
                     fmt::format("there {} only {}, so there is never a break",
                                 trials == 1 ? "is" : "are",
                                 counted(trials, "trial")),
                     "lower it, or remove \"breaks\"");
  }
  if (every > 0 && protocol.breaks.text.empty()) {
    findings.warning("/breaks", "breaks without a text", "tell the participant how to go on");
  }
}

void judge_lists(const Protocol& protocol, std::size_t words, Findings& findings) {
  const std::size_t conditions = protocol.conditions.size();
  if (protocol.assignment != Assignment::Once || conditions == 0) return;
  if (words < conditions) {
    findings.warning(
        "/words",
        fmt::format("{} words for {} conditions: each participant misses some condition",
                    words,
                    conditions),
        "add words, or choose the assignment \"every-condition\"");
  } else if (words % conditions != 0) {
    findings.warning("/words",
                     fmt::format("{} words do not divide by {} conditions: some conditions get one "
                                 "word more than others",
                                 words,
                                 conditions),
                     fmt::format("use {} or {} words, or accept it",
                                 words - words % conditions,
                                 words - words % conditions + conditions));
  }
}

void judge_practice(const Protocol& protocol,
                    const std::vector<Word>& words,
                    const std::vector<Word>& practice,
                    Findings& findings) {
  if (practice.empty()) return;
  std::set<std::string_view> main;
  for (const auto& word : words) main.insert(word.spelling);
  for (std::size_t i = 0; i < practice.size(); ++i) {
    if (!main.contains(practice[i].spelling)) continue;
    findings.warning("/practice/words",
                     fmt::format("the practice word {} is also a word of the experiment",
                                 shown(practice[i].spelling)),
                     "choose another, or its second appearance is no surprise");
  }
  if (practice.size() < protocol.conditions.size()) {
    findings.warning("/practice/words",
                     fmt::format("{} practice words for {} conditions: some are not practised",
                                 practice.size(),
                                 protocol.conditions.size()),
                     "add words; conditions are practised in turn");
  }
}

}  // namespace

void judge_meaning(const Protocol& protocol,
                   const std::vector<Word>& words,
                   const std::vector<Word>& practice,
                   Findings& findings) {
  judge_band(protocol, findings);
  judge_ramps(protocol, findings);
  judge_intervals(protocol, findings);
  judge_window(protocol, findings);
  judge_face(protocol, findings);
  judge_response(protocol, words, findings);
  judge_timing(protocol, findings);
  judge_triggers(protocol, findings);
  if (words.empty()) return;
  judge_breaks(protocol, words.size(), findings);
  if (findings.faulty("/words") || findings.faulty("/conditions")) return;
  judge_lists(protocol, words.size(), findings);
  judge_practice(protocol, words, practice, findings);
}

}  // namespace bimodal::protocols
