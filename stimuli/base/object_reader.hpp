#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "stimuli/base/findings.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal {

/// What a number may be; `meaning` completes the remedy "give ...".
struct NumberRule {
  double low = 0;  ///< both included
  double high = 0;
  std::string_view meaning;  ///< "the ratio in dB, e.g. -8"
};

/// What a text may be.
struct TextRule {
  std::size_t shortest = 0;  ///< characters (code points)
  std::size_t longest = 4'000;
  /// No line breaks or tabs, no blanks at the ends. Other control characters are never allowed.
  bool one_line = true;
  std::string_view meaning;  ///< "a title, e.g. \"Words in noise\""
};

/// "did you mean "x"? Known here: "x", "y"", the first half only where something is near.
[[nodiscard]] std::string suggestion(std::string_view typed,
                                     std::span<const std::string_view> known);

/// Reads one JSON object key by key. Every key that is asked for is thereby known; in the end
/// refuse_unknown_keys() reports all others. A reading function notes the mistake and returns
/// nothing where the key is absent or its value bad, so that a default stays: `if (const auto
/// width = reader.whole("width", ...)) window.width = *width;`
class ObjectReader {
 public:
  /// If `value` is no object, that is noted and every key is absent. Both are borrowed.
  ObjectReader(const nlohmann::json& value, std::string pointer, Findings& findings);

  /// Whether the key is there (even as null); makes it known.
  [[nodiscard]] bool has(std::string_view key);

  /// The value of a key; nullptr if absent.
  [[nodiscard]] const nlohmann::json* find(std::string_view key);

  /// As find; an absent key is an error. `meaning` completes "give ...".
  const nlohmann::json* require(std::string_view key, std::string_view meaning);

  [[nodiscard]] std::optional<std::string> text(std::string_view key, const TextRule& rule);
  [[nodiscard]] std::optional<double> number(std::string_view key, const NumberRule& rule);
  /// As number, and without a fraction; at most 2^53 in size, so that every JSON reader agrees.
  [[nodiscard]] std::optional<std::int64_t> whole(std::string_view key, const NumberRule& rule);
  [[nodiscard]] std::optional<bool> flag(std::string_view key);
  /// A number of seconds or milliseconds, as `unit` says; rounded to the nearest nanosecond.
  [[nodiscard]] std::optional<Duration> time(std::string_view key,
                                             Duration unit,
                                             const NumberRule& rule);
  /// One of a few names, as its index.
  [[nodiscard]] std::optional<std::size_t> choice(std::string_view key,
                                                  std::span<const std::string_view> names);
  [[nodiscard]] std::optional<ObjectReader> object(std::string_view key);
  /// An array of at least `fewest` and at most `most` items; each with its own pointer.
  [[nodiscard]] std::vector<std::pair<const nlohmann::json*, std::string>> items(
      std::string_view key, std::size_t fewest, std::size_t most);

  /// The same judgements of an item of an array.
  [[nodiscard]] std::optional<std::string> text_of(const nlohmann::json& value,
                                                   const std::string& pointer,
                                                   const TextRule& rule);
  [[nodiscard]] std::optional<double> number_of(const nlohmann::json& value,
                                                const std::string& pointer,
                                                const NumberRule& rule);

  void refuse_unknown_keys();

  [[nodiscard]] std::string pointer_to(std::string_view key) const;

  [[nodiscard]] const std::string& pointer() const { return pointer_; }

 private:
  [[nodiscard]] std::optional<double> judge_number(const nlohmann::json& value,
                                                   const std::string& pointer,
                                                   const NumberRule& rule,
                                                   bool whole);
  void wrong_type(const std::string& pointer,
                  const nlohmann::json& value,
                  std::string_view wanted,
                  std::string remedy);

  const nlohmann::json* object_;  ///< nullptr: not an object
  std::string pointer_;
  Findings* findings_;
  std::vector<std::string_view> known_;
};

}  // namespace bimodal
