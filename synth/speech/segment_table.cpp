#include "synth/speech/segment_table.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::synth {

static_assert(static_cast<std::size_t>(Phone::UW) + 1 == kFaceSegmentCount,
              "the diphthongs stand last, so that a phone is an index of the table");

SegmentTarget between(const SegmentTarget& from, const SegmentTarget& to, double share) {
  if (share <= 0) return from;
  if (share >= 1) return to;
  auto first = from.dominance;
  auto last = to.dominance;
  if (first.inflection_ms == Dominance::kNoInflection) {
    first.inflection_ms = last.inflection_ms;
    first.theta_early = first.theta_before;
  }
  if (last.inflection_ms == Dominance::kNoInflection) {
    last.inflection_ms = first.inflection_ms;
    last.theta_early = last.theta_before;
  }
  SegmentTarget made = from;
  made.target = std::lerp(from.target, to.target, share);
  made.offset = Milliseconds{std::lerp(from.offset.count(), to.offset.count(), share)};
  made.dominance = {.alpha = std::lerp(first.alpha, last.alpha, share),
                    .theta_before = std::lerp(first.theta_before, last.theta_before, share),
                    .theta_after = std::lerp(first.theta_after, last.theta_after, share),
                    .exponent = std::lerp(first.exponent, last.exponent, share),
                    .form = share < 0.5 ? first.form : last.form,
                    .inflection_ms = Dominance::kNoInflection};
  if (first.inflection_ms != Dominance::kNoInflection) {
    made.dominance.inflection_ms = std::lerp(first.inflection_ms, last.inflection_ms, share);
    made.dominance.theta_early = std::lerp(first.theta_early, last.theta_early, share);
  }
  return made;
}

SegmentTable::SegmentTable(const std::filesystem::path& file) {
  std::vector<Diagnostic> diagnostics;
  auto table = parse(read_file(file), file.string(), diagnostics);
  if (!table) {
    std::string message = fmt::format("cannot use the segment table '{}':", file.string());
    for (const auto& diagnostic : diagnostics) message += "\n  " + describe(diagnostic);
    throw Error{message};
  }
  *this = *std::move(table);
}

const SegmentTarget& SegmentTable::at(Phone segment, Control control) const {
  const auto row = static_cast<std::size_t>(segment);
  const auto column = static_cast<std::size_t>(control);
  assert(row < kFaceSegmentCount && column < kSpeechControlCount);
  return targets_[row][column];
}

SegmentTarget SegmentTable::at(const Segment& segment, Control control) const {
  const auto& from = at(segment.from, control);
  const auto& to = at(segment.to, control);
  const bool is_end = segment.step == 0 || segment.step == segment.steps;
  if (is_end || !makes_contact(control) || from.target == to.target) {
    return between(from, to, segment.share());
  }
  const auto& range = describe(control);
  auto reached = from;
  auto other = to;
  reached.target = std::clamp(from.target, range.lowest, range.highest);
  other.target = std::clamp(to.target, range.lowest, range.highest);
  return between(reached, other, segment.share());
}

}  // namespace bimodal::synth
