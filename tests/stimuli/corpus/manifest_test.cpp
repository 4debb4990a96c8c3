#include <fstream>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "stimuli/corpus/corpus.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kDigest(64, 'a');

const std::string kManifest = R"({
  "bimodal_corpus": 1,
  "name": "two words",
  "recordings": [
    {"file": "media/one.mpg", "sha256": ")" +
                              kDigest +
                              R"(", "talker": "s1", "licence": "CC BY 4.0", "eye_distance_px": 70.5}
  ],
  "items": [
    {"item": "blue", "word": "blue", "recording": "media/one.mpg", "start_s": 1.0, "end_s": 1.5, "phones": "B L UW", "times_s": [1.1, 1.2, 1.25, 1.4]},
    {"item": "blue-2", "word": "blue", "recording": "media/one.mpg", "start_s": 2.0, "end_s": 2.5, "phones": "B L UW", "times_s": [2.1, 2.2, 2.25, 2.4], "doubt": "clipped", "accepted": "loud"}
  ]
}
)";

std::string findings_of(const std::string& text) {
  std::vector<Diagnostic> found;
  static_cast<void>(parse_corpus(text, "talker/corpus.json", found));
  std::string all;
  for (const auto& diagnostic : found) all += describe(diagnostic) + "\n";
  return all;
}

std::string with(const std::string& from, const std::string& to) {
  auto text = kManifest;
  text.replace(text.find(from), from.size(), to);
  return text;
}

Corpus good() {
  std::vector<Diagnostic> found;
  auto corpus = parse_corpus(kManifest, "talker/corpus.json", found);
  EXPECT_THAT(found, IsEmpty());
  return corpus;
}

TEST(Manifest, IsReadWhole) {
  const auto corpus = good();
  EXPECT_EQ(corpus.name, "two words");
  EXPECT_EQ(corpus.folder, "talker");
  ASSERT_EQ(corpus.recordings.size(), 1U);
  EXPECT_EQ(corpus.recordings[0].eye_distance_px, 70.5);
  ASSERT_EQ(corpus.items.size(), 2U);
  EXPECT_EQ(corpus.items[0].start, 1s);
  EXPECT_EQ(corpus.items[0].phones[2], (TimedPhone{Phone::UW, 1250ms, 150ms}));
  EXPECT_EQ(corpus.items[1].doubt, "clipped");
  EXPECT_EQ(corpus.items[1].accepted, "loud");
  EXPECT_EQ(media_file(corpus, 0), "talker/media/one.mpg");
}

TEST(Manifest, GivesTheFirstItemOfAWordThatIsNotDoubtful) {
  auto corpus = good();
  EXPECT_EQ(find_item(corpus, "blue")->name, "blue");
  corpus.items[0].doubt = "says \"glue\"";
  EXPECT_EQ(find_item(corpus, "blue"), nullptr);
  EXPECT_EQ(find_item(corpus, "red"), nullptr);
}

TEST(Manifest, TimesOfAnItemCountFromItsStart) {
  const auto utterance = utterance_of(good().items[0]);
  ASSERT_EQ(utterance.phones.size(), 5U);
  EXPECT_EQ(utterance.phones[0], (TimedPhone{Phone::Rest, 0s, 100ms}));
  EXPECT_EQ(utterance.phones[1], (TimedPhone{Phone::B, 100ms, 100ms}));
  EXPECT_EQ(utterance.phones[4], (TimedPhone{Phone::Rest, 400ms, 100ms}));
  EXPECT_EQ(utterance.end(), 500ms);
}

TEST(Manifest, IsWrittenAsItIsRead) {
  const auto folder =
      std::filesystem::path{testing::TempDir()} / ("manifest_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  auto corpus = good();
  corpus.folder = folder;
  corpus.items[0].end = 1500000us + 3600s;  // an hour later, to the microsecond
  corpus.items[0].phones.back().duration = 3600123457us;
  corpus.items[0].end = 3700s;
  write_corpus(corpus);
  std::vector<Diagnostic> found;
  const auto back = read_corpus(folder, found);
  EXPECT_THAT(found, IsEmpty());
  EXPECT_EQ(back.items, corpus.items);
  EXPECT_EQ(back.recordings, corpus.recordings);
  EXPECT_EQ(back.sha256.size(), 64U);
  std::filesystem::remove_all(folder);
}

TEST(Manifest, NamesWhatIsWrongWithLinePointerAndRemedy) {
  EXPECT_THAT(findings_of(with("media/one.mpg\", \"sha", "../one.mpg\", \"sha")),
              HasSubstr("corpus.json:5: /recordings/0/file: \"../one.mpg\" leads out of the "
                        "corpus's folder; put the file into the folder"));
  EXPECT_THAT(findings_of(with(kDigest, "123")), HasSubstr("\"123\" is no SHA-256"));
  EXPECT_THAT(findings_of(with("\"item\": \"blue-2\"", "\"item\": \"blue\"")),
              HasSubstr("corpus.json:9: /items/1/item: \"blue\" names two items"));
  EXPECT_THAT(findings_of(with("1.1, 1.2,", "1.1,")), HasSubstr("3 times for 3 phones"));
  EXPECT_THAT(findings_of(with("1.1, 1.2,", "1.3, 1.2,")), HasSubstr("B ends before it begins"));
  EXPECT_THAT(findings_of(with("1.1, 1.2,", "0.9, 1.2,")),
              HasSubstr("a phone stands outside of the item"));
  EXPECT_THAT(findings_of(with("B L UW", "B Q UW")), HasSubstr("\"Q\" is not a phone"));
  EXPECT_THAT(findings_of(with("\"recording\": \"media/one.mpg\"", "\"recording\": \"two\"")),
              HasSubstr("there is no recording \"two\""));
  EXPECT_THAT(findings_of(with("\"talker\": \"s1\"", "\"taker\": \"s1\"")),
              testing::AllOf(HasSubstr("\"talker\""), HasSubstr("\"taker\"")));
  EXPECT_THAT(findings_of("{"), HasSubstr("corpus.json:1"));
  EXPECT_THAT(findings_of("[]"), HasSubstr("is not an object"));
  EXPECT_THAT(findings_of("{}"), HasSubstr("\"recordings\""));
}

TEST(Manifest, AMissingOneIsTold) {
  std::vector<Diagnostic> found;
  static_cast<void>(read_corpus("no/such/folder", found));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(describe(found[0]), HasSubstr("`bimodal corpus build` makes one"));
}

TEST(Manifest, MutatedOnesAreJudgedAndNeverCrash) {
  std::mt19937 random{3};
  for (int round = 0; round < 5'000; ++round) {
    auto text = kManifest;
    const auto place = [&] {
      return std::uniform_int_distribution<std::size_t>{0, text.size() - 1}(random);
    };
    for (auto changes = random() % 4 + 1; changes > 0 && !text.empty(); --changes) {
      switch (random() % 4) {
        case 0:
          text[place()] = static_cast<char>(random());
          break;
        case 1:
          text.erase(place(), random() % 30);
          break;
        case 2:
          text.insert(place(), kManifest.substr(place() % kManifest.size(), random() % 40));
          break;
        default:
          text.resize(place());
          break;
      }
      if (text.empty()) text = " ";
    }
    std::vector<Diagnostic> found;
    const auto corpus = parse_corpus(text, "corpus.json", found);
    for (const auto& item : corpus.items) {
      ASSERT_LT(item.recording, corpus.recordings.size());
      ASSERT_EQ(utterance_of(item).end(), item.end - item.start);
    }
  }
}

}  // namespace
}  // namespace bimodal
