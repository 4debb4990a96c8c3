// Mutations of a good protocol, drawn from a stated seed: whatever is done to the file, the reader
// neither crashes nor hangs nor accepts what it should not.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/design/plan.hpp"
#include "protocols/reading/read_protocol.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/random.hpp"
#include "tests/support/face_terms.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::protocols {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kDictionary = "cat K AE T\ndog D AO G\nfish F IH SH\n";

class MutatedProtocol : public ::testing::Test {
 protected:
  /// words414 with three words of its own, so that no list is read anew for each mutation, and the
  /// synthetic face in the place of the natural one.
  MutatedProtocol() : good_(Json::parse(read_file(asset("protocols/library/words414.json")))) {
    good_["words"] = {"cat", "dog", "fish"};
    good_["practice"]["words"] = {"dog"};
    good_["conditions"][3]["visual"]["otherwise"] = "face";
    good_["face"] = {{"view", "side"},
                     {"show", {"lips", "teeth", "tongue"}},
                     {"transparency", 0.5},
                     {"expression", {{"smile", 0.5}}},
                     {"controls", {{"gaze_x", 3}}}};
    good_["conditions"][1]["visual"]["face"] = {{"hide", {"tongue"}}, {"points", "lips"}};
  }

  /// Reads, and checks what must hold for every text.
  ReadProtocol judge(const std::string& text) const {
    auto read = read_protocol_text(
        text, files_.folder() / "x.json", {.dictionary = dictionary_, .face = known_face_terms()});
    const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
    for (const auto& diagnostic : read.diagnostics) {
      EXPECT_LE(diagnostic.line, lines);
      EXPECT_FALSE(diagnostic.finding.empty());
      EXPECT_FALSE(diagnostic.remedy.empty()) << diagnostic.finding;
      const auto message = describe(diagnostic);
      EXPECT_TRUE(std::ranges::none_of(message, [](char letter) {
        return letter >= 0 && letter < ' ' && letter != '\n';
      })) << message;
    }
    EXPECT_EQ(read.text, text);
    if (!has_errors(read.diagnostics)) expect_runnable(read);
    return read;
  }

  /// What the runner relies on in an accepted protocol.
  static void expect_runnable(const ReadProtocol& read) {
    const auto& protocol = read.protocol;
    ASSERT_FALSE(read.words.words.empty());
    ASSERT_FALSE(protocol.conditions.empty());
    for (const auto& condition : protocol.conditions) {
      EXPECT_FALSE(condition.name.empty());
      EXPECT_TRUE(condition.auditory_talker || condition.visual_talker);
      EXPECT_TRUE(!condition.snr || condition.auditory_talker);
    }
    for (const auto& word : read.words.words) EXPECT_FALSE(word.phones.empty());
    EXPECT_LE(protocol.sound.noise.band_high.count(), protocol.sound.rate.count() / 2);
    EXPECT_GE(protocol.window.width, 320);
    EXPECT_EQ(make_plan(protocol, read.words, read.practice, {1, 1}).size(),
              read.words.words.size() + read.practice.size());
  }

  WrittenFiles files_;
  std::filesystem::path dictionary_ = files_.write("dictionary.dict", kDictionary);
  Json good_;
};

TEST_F(MutatedProtocol, OriginalIsAccepted) {
  EXPECT_FALSE(has_errors(judge(good_.dump(2)).diagnostics));
}

TEST_F(MutatedProtocol, NeverBreaksTheReaderWhenBytesChange) {
  const auto original = good_.dump(2);
  Random random{1};
  for (int i = 0; i < 1'500; ++i) {
    auto text = original;
    for (auto changes = 1 + random.below(4); changes > 0; --changes) {
      const auto at = random.below(text.size());
      switch (random.below(4)) {
        case 0:
          text[at] = static_cast<char>(random.below(256));
          break;
        case 1:
          text.erase(at, 1 + random.below(20));
          break;
        case 2:
          text.insert(at, 1 + random.below(100), "{}[]\",:0-\\"[random.below(10)]);
          break;
        default:
          text.insert(at, text.substr(random.below(text.size()), random.below(200)));
      }
    }
    judge(text);
  }
}

TEST_F(MutatedProtocol, NeverBreaksTheReaderWhenItIsCutOff) {
  const auto original = good_.dump(1);
  for (std::size_t size = 0; size < original.size(); size += 7) {
    EXPECT_TRUE(has_errors(judge(original.substr(0, size)).diagnostics)) << size;
  }
}

/// The pointers of all values below the root.
std::vector<std::string> pointers(const Json& value) {
  std::vector<std::string> all;
  const auto flat = value.flatten();
  for (const auto& [pointer, leaf] : flat.items()) {
    for (auto end = pointer.size(); end > 0 && end != std::string::npos;
         end = pointer.rfind('/', end - 1)) {
      all.push_back(pointer.substr(0, end));
    }
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

TEST_F(MutatedProtocol, IsNeverAcceptedWithAKeyOfAWrongType) {
  // No key takes a value of every kind, so one of these at least is refused everywhere.
  const std::vector<Json> kinds{
      nullptr, true, -1e300, 0.5, "", "x\u0001", Json::array(), Json::object()};
  for (const auto& pointer : pointers(good_)) {
    std::size_t accepted = 0;
    for (const auto& kind : kinds) {
      auto mutated = good_;
      mutated[Json::json_pointer{pointer}] = kind;
      if (!has_errors(judge(mutated.dump()).diagnostics)) ++accepted;
    }
    EXPECT_LE(accepted, 2U) << pointer;
  }
}

TEST_F(MutatedProtocol, IsNeverAcceptedWithAnUnknownKey) {
  for (const auto& pointer : pointers(good_)) {
    const Json::json_pointer where{pointer};
    if (!good_[where].is_object()) continue;
    auto mutated = good_;
    mutated[where]["unheard_of"] = 1;
    std::vector<std::string> errors;
    for (const auto& found : judge(mutated.dump()).diagnostics) {
      if (found.severity == Severity::Error) errors.push_back(found.pointer);
    }
    EXPECT_EQ(errors, std::vector{pointer + "/unheard_of"});
  }
}

}  // namespace
}  // namespace bimodal::protocols
