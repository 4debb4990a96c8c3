#include "synth/speech/score.hpp"

#include <algorithm>
#include <cassert>
#include <set>

#include "synth/speech/claims.hpp"

namespace bimodal::synth {

namespace {

/// A part of a score that claims as one segment.
struct Part {
  TimedSegment timed;
  const ScoreSegment* written;
  bool is_first_of_written;
};

std::vector<Part> parts_of(const Score& score) {
  std::vector<Part> parts;
  for (const auto& written : score.segments) {
    const TimedSegment whole{.segment = written.segment.value_or(Segment{}),
                             .start = written.start,
                             .duration = written.duration};
    if (!written.segment || score.is_complete()) {
      parts.push_back({.timed = whole, .written = &written, .is_first_of_written = true});
      continue;
    }
    const bool continues_rest = *written.segment == Phone::Rest && written.controls.empty() &&
                                !parts.empty() && parts.back().written->segment == Phone::Rest &&
                                parts.back().written->controls.empty();
    if (continues_rest) {
      parts.back().timed.duration = whole.end() - parts.back().timed.start;
      continue;
    }
    bool is_first = true;
    for (const auto& timed : face_segments(std::span{&whole, 1})) {
      parts.push_back({.timed = timed, .written = &written, .is_first_of_written = is_first});
      is_first = false;
    }
  }
  return parts;
}

Claimant claimant_of(const Part& part) {
  auto claimant = claimants_of(std::span{&part.timed, 1}).front();
  if (part.written->rank) claimant.rank = *part.written->rank;
  return claimant;
}

Milliseconds centre_of(const ScoreSegment& segment) {
  return segment.start + segment.duration / 2;
}

/// Claims of the score's own definitions, and for a face's control those of the inventory.
std::vector<Claim> claims_on(const std::string& name,
                             const std::vector<Part>& parts,
                             const SegmentTable* table) {
  const auto control = control_from_name(name);
  std::vector<Claim> claims;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& part = parts[i];
    const auto own = part.written->controls.find(name);
    if (own != part.written->controls.end()) {
      if (part.is_first_of_written) {
        claims.push_back(claim_of(own->second, centre_of(*part.written), i));
      }
    } else if (table != nullptr && control && part.written->segment) {
      claims.push_back(claim_on(*control, part.timed, i, i + 1 == parts.size(), *table));
    }
  }
  return claims;
}

}  // namespace

bool Score::is_complete() const {
  return std::ranges::all_of(segments,
                             [](const ScoreSegment& segment) { return !segment.controls.empty(); });
}

Score score_of(std::span<const TimedSegment> utterance) {
  Score score;
  for (const auto& timed : utterance) {
    score.segments.push_back({.symbol = symbol(timed.segment),
                              .segment = timed.segment,
                              .start = timed.start,
                              .duration = timed.duration});
  }
  return score;
}

Score at_rate(Score score, double rate) {
  assert(rate > 0);
  for (auto& segment : score.segments) {
    segment.start /= rate;
    segment.duration /= rate;
  }
  return score;
}

std::unique_ptr<const Movement> ScoreClaims::movement(Account account) const {
  return synth::movement(account, claimants, claims, contact_rows(controls));
}

std::vector<std::size_t> contact_rows(std::span<const std::string> controls) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const auto control = control_from_name(controls[i]);
    if (control && makes_contact(*control)) rows.push_back(i);
  }
  return rows;
}

namespace {

/// `table` is null where the score is complete.
ScoreClaims claims_by(const Score& score, const SegmentTable* table) {
  assert(!score.segments.empty());
  const auto parts = parts_of(score);
  ScoreClaims made;
  made.end = score.end();
  for (const auto& part : parts) {
    made.claimants.push_back(claimant_of(part));
    made.symbols.push_back(part.written->segment && !score.is_complete()
                               ? symbol(part.timed.segment)
                               : part.written->symbol);
  }
  std::set<std::string, std::less<>> own;
  for (const auto& segment : score.segments) {
    for (const auto& [name, ignored] : segment.controls) own.insert(name);
  }
  const bool asks_inventory = table != nullptr;
  for (const auto& name : own) {
    if (!asks_inventory || !control_from_name(name)) made.controls.push_back(name);
  }
  const bool is_known = std::ranges::any_of(
      score.segments, [](const ScoreSegment& segment) { return segment.segment.has_value(); });
  if (asks_inventory && is_known) {
    for (const auto& description : controls().first<kSpeechControlCount>()) {
      made.controls.emplace_back(description.name);
    }
  }
  for (const auto& name : made.controls) {
    made.claims.push_back(claims_on(name, parts, table));
  }
  return made;
}

}  // namespace

ScoreClaims claims_of(const Score& score, const SegmentTable& table) {
  return claims_by(score, score.is_complete() ? nullptr : &table);
}

ScoreClaims claims_of(const Score& score) {
  assert(score.is_complete());
  return claims_by(score, nullptr);
}

}  // namespace bimodal::synth
