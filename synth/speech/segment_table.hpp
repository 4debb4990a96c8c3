#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/base/diagnostic.hpp"
#include "stimuli/base/quantity.hpp"
#include "stimuli/timeline/segment.hpp"
#include "synth/speech/control.hpp"
#include "synth/speech/dominance.hpp"

namespace bimodal::synth {

/// The segments that a face articulates: rest, 25 consonants, 13 vowels. The diphthongs AY AW OY
/// are two segments each (face_segments) and have no rows of their own.
inline constexpr std::size_t kFaceSegmentCount = 39;

/// What one segment asks of one control.
struct SegmentTarget {
  double target = 0;            ///< T, in the control's unit; may lie beyond its range
  Dominance dominance;          ///< an inflection is counted from the segment's centre
  Milliseconds offset{};        ///< t_o: peak of dominance, counted from the segment's centre
  std::string target_source;    ///< key of sources(): where `target` comes from
  std::string dynamics_source;  ///< key of sources(): where `dominance` and `offset` come from
};

/// What lies `share` (0 to 1) of the way from one to the other: target, alpha, both thetas,
/// exponent and offset in proportion. Where only one of them changes its theta on the way to the
/// peak, the other counts as one whose theta stays the same there. The form is that of the nearer
/// (in a SegmentTable both have the same); the sources are those of `from`, unless `share` is 1.
[[nodiscard]] SegmentTarget between(const SegmentTarget& from,
                                    const SegmentTarget& to,
                                    double share);

using SegmentTargets =
    std::array<std::array<SegmentTarget, kSpeechControlCount>, kFaceSegmentCount>;

/// Target and dominance of every segment for every speech control: the language's articulation as
/// data, synth/assets/segments/english.json.
///
/// The file is `{"about": [...], "sources": {key: reference}, "groups": {name: {"columns": [...],
/// "rows": {"P B M": [...]}}}}`. A group holds controls that move with the same dynamics; its
/// columns are alpha, theta_before, theta_after (1/ms), offset_ms, dynamics (a source), targets (a
/// source), where they are wanted exponent, inflection_ms and theta_early (both null where theta
/// does not change), and then one target per control. A row's key names one segment or several,
/// parted by spaces. "form": "critically damped" gives a group that form. Nothing else has a
/// default: each segment has a row in each group, and each speech control belongs to one group.
///
/// A file with "extends": "english.json" changes another one: its groups have only the rows, and
/// only the controls, that differ.
class SegmentTable {
 public:
  /// Throws Error listing every mistake of the file, or that it cannot be read.
  explicit SegmentTable(const std::filesystem::path& file);

  /// Reads the table from `text`. Appends every mistake to `diagnostics`, under the name `file`;
  /// absent if there was an error.
  [[nodiscard]] static std::optional<SegmentTable> parse(std::string_view text,
                                                         std::string_view file,
                                                         std::vector<Diagnostic>& diagnostics);

  /// Preconditions: `segment` is not a diphthong, `control` is a speech control.
  [[nodiscard]] const SegmentTarget& at(Phone segment, Control control) const;

  /// Of an ambiguous segment: everything in proportion between its two phones. Only contacts (see
  /// makes_contact), where the two phones differ in them, count from the limits of their range
  /// between the ends: a phone's virtual target makes its contact last, but what lies between two
  /// phones shall not make the contact of one of them for half of the way, and then jump. At either
  /// end it is that phone, virtual targets and all. The same preconditions.
  [[nodiscard]] SegmentTarget at(const Segment& segment, Control control) const;

  /// SHA-256 of the text, followed by this digest of the file that it extends, if any: two tables
  /// of the same digest are the same.
  [[nodiscard]] const std::string& sha256() const { return sha256_; }

  /// What each source key stands for.
  [[nodiscard]] const std::map<std::string, std::string>& sources() const { return sources_; }

 private:
  friend class SegmentTableReader;
  SegmentTable() = default;

  SegmentTargets targets_;
  std::map<std::string, std::string> sources_;
  std::string sha256_;
};

}  // namespace bimodal::synth
