#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "protocols/model/protocol.hpp"
#include "protocols/reading/read_condition.hpp"
#include "protocols/reading/read_face.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/timeline/segment.hpp"

namespace bimodal::protocols {

/// The format that this program reads: the value of the key "bimodal_protocol".
inline constexpr int kProtocolFormat = 1;

/// A word as it is spelled out in a protocol.
struct WrittenWord {
  std::string pointer;        ///< where it is written
  std::string spelling;       ///< lower case
  SpelledSegments said;       ///< no phones: to be looked up
  std::string seen;           ///< lower case; empty: the same word
  SpelledSegments seen_said;  ///< no phones: those of a word of the list, or to be looked up
};

/// Words as a protocol asks for them: the name of a list, or the words themselves.
struct WordChoice {
  std::string pointer;  ///< where it is written
  std::string list;     ///< "monosyllables-414", "lists/mine.json"; or empty, and
  std::vector<WrittenWord> words;
};

/// What the keys of a protocol say, each judged by itself. What could not be read has its default.
struct Structure {
  /// Practice words are still to be looked up, conditions to be chosen and their talkers found.
  Protocol protocol;
  std::vector<WrittenCondition> conditions;
  std::optional<WordChoice> words;
  std::optional<WordChoice> practice;
};

/// Reads every key and notes every mistake. Of a protocol in a newer format it says only that.
[[nodiscard]] Structure read_structure(const nlohmann::json& json,
                                       const FaceReader& faces,
                                       Findings& findings);

}  // namespace bimodal::protocols
