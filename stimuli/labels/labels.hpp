#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/base/quantity.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

/// What stands over a stretch of a recording, or, where start and end are equal, at a point of it.
struct Label {
  Duration start{};
  Duration end{};
  std::string text;  ///< UTF-8, blanks at its ends removed, line breaks '\n'

  bool operator==(const Label&) const = default;
};

/// Labels of one kind in order of time, from 0, without overlap; gaps are allowed.
struct Tier {
  std::string name;
  std::vector<Label> labels;

  bool operator==(const Tier&) const = default;
};

/// The labels of one recording, whatever file they came from.
struct Labels {
  Duration end{};  ///< the length of the recording, or the end of the last label
  std::vector<Tier> tiers;

  bool operator==(const Labels&) const = default;
};

/// The first tier of one of the names "phones", "phone", "segments", "segment", "phonemes",
/// "phoneme" in any case; nullptr if there is none.
[[nodiscard]] const Tier* phone_tier(const Labels& labels);

/// The same for "words", "word", "text", "orthography".
[[nodiscard]] const Tier* word_tier(const Labels& labels);

/// Whether a label stands for silence: empty, or in any case "sil", "sp", "pau", "rest", "#", "h#",
/// "<sil>", "<p:>", "_", "...".
[[nodiscard]] bool is_silence(std::string_view text);

/// The labels of a tier of phones that utterance_of does not know; empty if it knows all.
[[nodiscard]] std::vector<Label> not_phones(const Tier& tier);

/// The timed phones of a tier of phones whose recording ends at `end`. Names may be, in any case
/// and with or without stress digits, ARPAbet, those of Festival's phone set "radio" (see
/// phones_from_festival), or TIMIT's:
///   bcl dcl gcl pcl tcl kcl   one phone with the stop of the same place that follows (dcl, tcl:
///                             also the affricate); without it the stop itself
///   q                         no phone: its time goes to the phone that follows, before rest to
///   the
///                             one before it, between rests to rest
///   epi, ux, ix, ax-h, eng    rest, UW, IH, AX, NG
/// Syllabic el em en are halved into AX and the consonant. Gaps and silent labels become rest,
/// neighbouring rests one; gaps up to 1 us are closed. The utterance begins at 0 and ends at `end`.
/// Throws Error that names the tier, the time and the text of a label that is no phone, has no
/// length or lies beyond `end`, and what to write instead.
[[nodiscard]] Utterance utterance_of(const Tier& tier, Duration end);

/// Two tiers, "words" (if there are any) and "phones", for writing. Rests are labels "sil", so that
/// formats without gaps and without a length keep them; rests of no length are left out.
[[nodiscard]] Labels labels_of(const Utterance& utterance, std::vector<Label> words = {});

}  // namespace bimodal
