#pragma once

// What the tests of label files share: a folder, encodings, random labels.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"
#include "stimuli/labels/label_file.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::label_cases {

inline std::string message_of(const std::function<void()>& deed) {
  try {
    deed();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

inline std::string fault_of(std::string_view bytes, const std::string& name) {
  return message_of([&] { (void)parse_labels(bytes, name); });
}

inline std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

/// UTF-16 with byte order mark.
inline std::string utf16(std::u16string_view text, bool big_endian) {
  std::string bytes = big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char16_t unit : text) {
    const auto high = static_cast<char>(unit >> 8U);
    const auto low = static_cast<char>(unit & 0xFFU);
    bytes += big_endian ? high : low;
    bytes += big_endian ? low : high;
  }
  return bytes;
}

inline const std::vector<std::string>& words() {
  static const std::vector<std::string> some{"a",
                                             "AH0",
                                             "sil",
                                             "two words",
                                             "say \"hi\"",
                                             "it's",
                                             "back\\slash",
                                             "comma, semicolon;",
                                             "\xC9\x91\xCB\x90",
                                             "\xF0\x9F\x98\x80",
                                             "<p:>",
                                             "! no comment",
                                             "-1",
                                             "0.5",
                                             "///",
                                             "'em",
                                             "\"",
                                             "#"};
  return some;
}

/// What the labels are to be.
struct RandomShape {
  Duration grid{1};    ///< all times are its multiples
  bool points = true;  ///< labels of no length among them, tiers of points
  bool line_breaks = true;
  std::size_t tiers = 3;  ///< at most, at least 1
};

inline Duration random_time(Random& random, Duration grid) {
  // Short and long: nanoseconds as well as minutes.
  static const std::vector<std::uint64_t> bounds{10, 100'000, 300'000'000, 60'000'000'000};
  return grid * static_cast<Duration::rep>(1 + random.below(bounds[random.below(4)]) /
                                                   static_cast<std::uint64_t>(grid.count()));
}

inline Tier random_tier(Random& random, const RandomShape& shape) {
  Tier tier;
  const bool only_points = shape.points && random.below(4) == 0;
  Duration reached{};
  const auto count = 1 + random.below(12);
  for (std::size_t i = 0; i < count; ++i) {
    if (random.below(2) == 0) reached += random_time(random, shape.grid);
    Label label{.start = reached, .end = reached, .text = words()[random.below(words().size())]};
    if (shape.line_breaks && random.below(8) == 0) label.text += "\nand more";
    const bool point = only_points || (shape.points && random.below(8) == 0);
    if (!point) label.end += random_time(random, shape.grid);
    if (point && shape.line_breaks && random.below(4) == 0) label.text.clear();
    reached = label.end;
    tier.labels.push_back(label);
  }
  return tier;
}

inline Labels random_labels(Random& random, const RandomShape& shape) {
  Labels labels;
  const auto count = 1 + random.below(shape.tiers);
  for (std::size_t i = 0; i < count; ++i) {
    labels.tiers.push_back(random_tier(random, shape));
    labels.tiers.back().name = "tier \"" + std::to_string(i) + "\", one";
    labels.end = std::max(labels.end, labels.tiers.back().labels.back().end);
  }
  return labels;
}

}  // namespace bimodal::label_cases
