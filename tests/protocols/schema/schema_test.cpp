// Holds the schema and the reader together: Debian's python3-jsonschema judges by the schema what
// the reader judges by itself. Skipped where that is not installed (./dev installs it).

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/reading/read_protocol.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/random.hpp"
#include "tests/support/face_terms.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::protocols {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kDictionary =
    "cat K AE T\ndog D AO G\nfish F IH SH\nmoon M UW N\nhouse HH AW S\n";

/// Everything that a command prints; absent if it fails.
std::optional<std::string> output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe{popen(command.c_str(), "r"),
                                                   [](FILE*) { return 0; }};
  if (!pipe) return std::nullopt;
  std::string text;
  std::array<char, 4096> part{};
  for (std::size_t size = 1; size > 0;) {
    size = std::fread(part.data(), 1, part.size(), pipe.get());
    text.append(part.data(), size);
  }
  if (pclose(pipe.get()) != 0) return std::nullopt;
  return text;
}

/// Debian's own Python, whatever else is first in the path.
constexpr const char* kPython = "/usr/bin/python3";

class Schema : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!output_of(fmt::format("{} -c 'import jsonschema' 2>/dev/null", kPython))) {
      GTEST_SKIP() << "the package python3-jsonschema is not installed";
    }
  }

  /// The schema's verdict on each protocol: "valid", or "invalid ...".
  std::vector<std::string> validate(const std::vector<Json>& protocols) const {
    const auto file = files_.write("protocols.json", Json(protocols).dump());
    const auto lines =
        output_of(fmt::format("{} '{}/protocols/schema/validate.py' '{}' '{}'",
                              kPython,
                              BIMODAL_TEST_ROOT,
                              asset("protocols/schema/protocol.schema.json").string(),
                              file.string()));
    std::vector<std::string> verdicts;
    std::string rest = lines.value_or("");
    for (auto end = rest.find('\n'); end != std::string::npos; end = rest.find('\n')) {
      verdicts.push_back(rest.substr(0, end));
      rest.erase(0, end + 1);
    }
    EXPECT_EQ(verdicts.size(), protocols.size()) << "validate.py failed";
    verdicts.resize(protocols.size());
    return verdicts;
  }

  std::string complaints(const Json& protocol) const {
    std::string errors;
    const auto read = read_protocol_text(protocol.dump(2),
                                         files_.folder() / "x.json",
                                         {.dictionary = dictionary_, .face = known_face_terms()});
    for (const auto& diagnostic : read.diagnostics) {
      if (diagnostic.severity == Severity::Error) errors += describe(diagnostic) + "\n";
    }
    return errors;
  }

  WrittenFiles files_;
  std::filesystem::path dictionary_ = files_.write("dictionary.dict", kDictionary);
};

Json cases() {
  return Json::parse(
      read_file(std::filesystem::path{BIMODAL_TEST_ROOT} / "protocols/cases/cases.json"));
}

Json changed(Json protocol, const Json& change) {
  const Json::json_pointer at{change.at("at").get<std::string>()};
  if (change.value("remove", false)) {
    auto& parent = protocol.at(at.parent_pointer());
    if (parent.is_array()) {
      parent.erase(std::stoul(at.back()));
    } else {
      parent.erase(at.back());
    }
  } else {
    protocol[at] = change.at("put");
  }
  return protocol;
}

TEST_F(Schema, AndReaderAgreeWithTheVerdictOnEveryCase) {
  const auto all = cases();
  std::vector<Json> protocols{all.at("base")};
  for (const auto& change : all.at("cases")) protocols.push_back(changed(all.at("base"), change));
  const auto verdicts = validate(protocols);
  EXPECT_EQ(verdicts[0], "valid");
  EXPECT_EQ(complaints(protocols[0]), "");
  for (std::size_t i = 1; i < protocols.size(); ++i) {
    const auto& change = all.at("cases")[i - 1];
    const auto verdict = change.at("verdict").get<std::string>();
    EXPECT_EQ(verdicts[i] == "valid", verdict != "structure") << change << ": " << verdicts[i];
    EXPECT_EQ(complaints(protocols[i]).empty(), verdict == "good")
        << change << ": " << complaints(protocols[i]);
  }
}

TEST_F(Schema, AcceptsTheLibrary) {
  std::vector<Json> protocols;
  for (const auto& entry : std::filesystem::directory_iterator{asset("protocols/library")}) {
    protocols.push_back(Json::parse(read_file(entry.path())));
  }
  for (const auto& verdict : validate(protocols)) EXPECT_EQ(verdict, "valid");
}

Json random_value(Random& random) {
  const std::vector<Json> values{nullptr,
                                 true,
                                 0,
                                 1,
                                 -1,
                                 0.5,
                                 60,
                                 320,
                                 1000.5,
                                 8192,
                                 1e18,
                                 "",
                                 "x",
                                 " x",
                                 "a\nb",
                                 "face",
                                 "festival:kal",
                                 "white",
                                 "#123456",
                                 Json::array(),
                                 {1, 2},
                                 {"cat", "dog"},
                                 Json::object(),
                                 {{"talker", "face"}},
                                 {{"words", {"fish"}}}};
  return values[random.below(values.size())];
}

// What the schema refuses, the reader refuses, whatever the file; the reader sees more.
TEST_F(Schema, RefusesNothingThatTheReaderAccepts) {
  const auto base = cases().at("base");
  std::vector<std::string> places;
  const auto flat = base.flatten();
  for (const auto& [pointer, leaf] : flat.items()) {
    for (auto end = pointer.size(); end > 0; end = pointer.rfind('/', end - 1)) {
      places.push_back(pointer.substr(0, end));
    }
  }
  Random random{3};
  std::vector<Json> protocols;
  for (int i = 0; i < 1'500; ++i) {
    auto protocol = base;
    for (auto changes = 1 + random.below(2); changes > 0; --changes) {
      const Json::json_pointer at{places[random.below(places.size())]};
      if (!protocol.contains(at)) continue;
      if (random.below(4) == 0) {
        protocol = changed(protocol, {{"at", at.to_string()}, {"remove", true}});
      } else {
        protocol[at] = random_value(random);
      }
    }
    protocols.push_back(std::move(protocol));
  }
  const auto verdicts = validate(protocols);
  std::size_t refused = 0;
  std::size_t accepted = 0;
  for (std::size_t i = 0; i < protocols.size(); ++i) {
    const bool reader_accepts = complaints(protocols[i]).empty();
    if (verdicts[i] != "valid") {
      ++refused;
      EXPECT_FALSE(reader_accepts) << protocols[i].dump() << "\n" << verdicts[i];
    }
    if (reader_accepts) ++accepted;
  }
  EXPECT_GT(refused, 100U);
  EXPECT_GT(accepted, 100U);
}

}  // namespace
}  // namespace bimodal::protocols
