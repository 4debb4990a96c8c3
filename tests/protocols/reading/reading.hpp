#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "protocols/reading/read_protocol.hpp"
#include "tests/support/face_terms.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::protocols {

inline constexpr std::string_view kDictionary =
    "cat K AE T\ndog D AO G\ndog(2) D AA G\nfish F IH SH\nhouse HH AW S\nmoon M UW N\n";

/// Every line has one key, so that line numbers are plain.
inline constexpr std::string_view kGood = R"({
  "bimodal_protocol": 1,
  "title": "Test",
  "seed": 7,
  "words": ["cat", "Dog"],
  "conditions": [
    {"name": "a", "auditory": {"talker": "festival:slt"}, "snr_db": -8},
    {"name": "v", "visual": {"talker": "face"}}
  ]
})";

class Reading : public ::testing::Test {
 protected:
  ReadProtocol read(std::string text) const {
    return read_protocol_text(std::move(text),
                              files_.folder() / "test.json",
                              {.dictionary = dictionary_, .face = known_face_terms()});
  }

  /// All messages of the good protocol with one part of its text replaced.
  std::vector<std::string> messages(std::string_view part, std::string_view replacement) const {
    std::string text{kGood};
    const auto at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    text.replace(at, part.size(), replacement);
    return messages(text);
  }

  std::vector<std::string> messages(const std::string& text) const {
    std::vector<std::string> lines;
    const auto folder = files_.folder().string() + "/";
    for (const auto& diagnostic : read(text).diagnostics) {
      auto line = describe(diagnostic);
      for (auto at = line.find(folder); at != std::string::npos; at = line.find(folder)) {
        line.erase(at, folder.size());
      }
      lines.push_back(line);
    }
    return lines;
  }

  /// With these keys added before the others (so their line is 2).
  std::vector<std::string> with(std::string_view keys) const {
    return messages("\n  \"bimodal", "\n  " + std::string{keys} + ", \"bimodal");
  }

  /// The protocol with these keys added, in which nothing may be wrong.
  Protocol protocol_with(std::string_view keys) const {
    std::string text{kGood};
    const auto read = this->read(text.insert(1, std::string{keys} + ", "));
    EXPECT_TRUE(read.diagnostics.empty());
    return read.protocol;
  }

  WrittenFiles files_;
  std::filesystem::path dictionary_ = files_.write("dictionary.dict", kDictionary);
};

}  // namespace bimodal::protocols
