#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/base/diagnostic.hpp"
#include "stimuli/timeline/segment.hpp"
#include "synth/speech/account.hpp"
#include "synth/speech/movement.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::synth {

/// What a segment asks of controls, by their names.
using NamedTargets = std::map<std::string, SegmentTarget, std::less<>>;

struct ScoreSegment {
  std::string symbol;              ///< as written
  std::optional<Segment> segment;  ///< absent if the inventory does not know the symbol
  Milliseconds start{};
  Milliseconds duration{};
  NamedTargets controls;    ///< of its own
  std::optional<int> rank;  ///< deformability of its own, 1 to 10

  [[nodiscard]] Milliseconds end() const { return start + duration; }
};

/// What is to be articulated, when: segments in order, without overlap. A score in which every
/// segment has controls of its own is complete: no inventory is asked. In any other, a segment that
/// the inventory knows asks what the inventory says of the face's speech controls, but for the
/// controls of its own.
struct Score {
  std::vector<ScoreSegment> segments;

  [[nodiscard]] Milliseconds end() const {
    return segments.empty() ? Milliseconds{} : segments.back().end();
  }

  [[nodiscard]] bool is_complete() const;
};

/// The score of timed segments that the inventory articulates.
[[nodiscard]] Score score_of(std::span<const TimedSegment> utterance);

/// The score at another speaking rate: 2 halves all durations, and leaves the dynamics alone
/// (Cohen & Massaro 1993, figure 11; their slow "2X" is rate 0.5). Precondition: rate > 0.
[[nodiscard]] Score at_rate(Score score, double rate);

inline constexpr double kSlowestRate = 0.3;
inline constexpr double kFastestRate = 3.0;

/// Reads `{"segments": [{"symbol": "S", "duration_ms": 140}, ...]}` (see synth/speech/README.md for
/// every key). Appends every mistake to `diagnostics`, under the name `file`; absent if there was
/// an error.
[[nodiscard]] std::optional<Score> parse_score(std::string_view text,
                                               std::string_view file,
                                               std::vector<Diagnostic>& diagnostics);

/// The same from a file; warnings are appended to `warnings`. Throws Error listing every mistake,
/// or that it cannot be read.
[[nodiscard]] Score read_score(const std::string& file, std::vector<Diagnostic>& warnings);

/// What the segments of a score claim of each control.
struct ScoreClaims {
  std::vector<std::string> controls;  ///< the score's own by name, then the face's speech controls
  std::vector<Claimant> claimants;   ///< the segments; diphthongs as two, neighbouring rests as one
  std::vector<std::string> symbols;  ///< of the claimants
  ControlClaims claims;              ///< one row per control
  Milliseconds end{};

  [[nodiscard]] std::unique_ptr<const Movement> movement(Account account) const;
};

/// Which of these controls are contacts of the face (see makes_contact).
[[nodiscard]] std::vector<std::size_t> contact_rows(std::span<const std::string> controls);

/// Precondition: the score has segments.
[[nodiscard]] ScoreClaims claims_of(const Score& score, const SegmentTable& table);

/// The same of a complete score.
[[nodiscard]] ScoreClaims claims_of(const Score& score);

}  // namespace bimodal::synth
