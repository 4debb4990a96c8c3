#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/base/quantity.hpp"

namespace bimodal::protocols {

/// From where reaction time counts.
enum class RtFrom {
  End,          ///< the planned end of everything that is seen and heard
  SoundOnset,   ///< the recording's time zero, as heard
  VisualOnset,  ///< the recording's time zero, as seen
};

/// How data files name it: "end", "sound_onset", "visual_onset".
[[nodiscard]] constexpr std::string_view name(RtFrom from) {
  switch (from) {
    case RtFrom::SoundOnset:
      return "sound_onset";
    case RtFrom::VisualOnset:
      return "visual_onset";
    case RtFrom::End:
      break;
  }
  return "end";
}

enum class ResponseKind {
  Typed,   ///< a word, letter by letter, then Enter
  Choice,  ///< one of a few options
};

/// From when on answers count.
enum class AnswersFrom {
  End,    ///< of everything that is seen and heard
  Onset,  ///< the recording's time zero, seen or heard, whichever comes first
};

/// One of the answers that can be chosen.
struct Option {
  std::string label;  ///< what the participant sees, and what is stored
  std::string key;    ///< one character, in any case; empty: it has none
  int button = 0;     ///< of a button box, from 1; 0: it has none

  bool operator==(const Option&) const = default;
};

/// How participants answer.
struct Response {
  ResponseKind kind = ResponseKind::Typed;
  std::string prompt = "Which word was it?";
  std::optional<Duration> time_limit;  ///< from stimulus offset; absent: the participant decides
  RtFrom rt_from = RtFrom::End;
  int longest = 40;  ///< characters of a typed answer

  std::vector<Option> options;          ///< of a choice: at least two
  bool pointer = false;                 ///< options can be clicked, too
  bool confirm = false;                 ///< a choice may be changed until Enter
  AnswersFrom from = AnswersFrom::End;  ///< of a choice; typed answers follow the stimulus
};

}  // namespace bimodal::protocols
