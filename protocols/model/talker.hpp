#pragma once

#include <string>
#include <string_view>

namespace bimodal::protocols {

/// A talker that is a corpus of recordings is named "corpus:NAME"; the others are "face" and the
/// voices "festival:kal", "festival:slt".
inline constexpr std::string_view kCorpusPrefix = "corpus:";

[[nodiscard]] constexpr bool is_corpus(std::string_view talker) {
  return talker.starts_with(kCorpusPrefix);
}

/// NAME of "corpus:NAME".
[[nodiscard]] inline std::string corpus_name(std::string_view talker) {
  return std::string{talker.substr(kCorpusPrefix.size())};
}

}  // namespace bimodal::protocols
