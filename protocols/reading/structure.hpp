#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "protocols/model/protocol.hpp"
#include "stimuli/base/findings.hpp"

namespace bimodal::protocols {

/// The format that this program reads: the value of the key "bimodal_protocol".
inline constexpr int kProtocolFormat = 1;

/// Words as a protocol asks for them: the name of a list, or the words themselves.
struct WordChoice {
  std::string pointer;                 ///< where it is written
  std::string list;                    ///< "monosyllables-414", "lists/mine.json"; or empty, and
  std::vector<std::string> spellings;  ///< the words, lower case
  std::vector<std::string> pointers;   ///< of each spelling
};

/// What the keys of a protocol say, each judged by itself. What could not be read has its default.
struct Structure {
  Protocol protocol;  ///< practice.words are still to be looked up
  std::optional<WordChoice> words;
  std::optional<WordChoice> practice;
};

/// Reads every key and notes every mistake. Of a protocol in a newer format it says only that.
[[nodiscard]] Structure read_structure(const nlohmann::json& json, Findings& findings);

}  // namespace bimodal::protocols
