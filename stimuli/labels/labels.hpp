#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/base/quantity.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

/// What stands over a stretch of a recording.
struct Label {
  Duration start{};
  Duration end{};
  std::string text;  ///< UTF-8, blanks at its ends removed

  bool operator==(const Label&) const = default;
};

/// Labels of one kind in order of time, without overlap; gaps are allowed.
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

/// The timed phones of a tier of phones in ARPAbet, with or without stress digits, or in Festival's
/// names (which see). Gaps and silent labels become rest, neighbouring rests one; the utterance
/// begins at 0 and ends at `end`. Throws Error that names the tier, the time and the text of a
/// label that is no phone, and what to write instead.
[[nodiscard]] Utterance utterance_of(const Tier& tier, Duration end);

/// Two tiers, "words" (if there are any) and "phones", for writing.
[[nodiscard]] Labels labels_of(const Utterance& utterance, std::vector<Label> words = {});

}  // namespace bimodal
