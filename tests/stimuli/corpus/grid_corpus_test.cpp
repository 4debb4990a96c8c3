#include <algorithm>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/corpus/build_corpus.hpp"
#include "stimuli/corpus/check_corpus.hpp"
#include "stimuli/corpus/word_list_of.hpp"
#include "stimuli/labels/label_file.hpp"
#include "stimuli/words/dictionary.hpp"
#include "tests/stimuli/corpus/corpus_folder.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;
using testing::IsEmpty;

/// One-syllable words of the six sentences that are not letters.
const std::vector<std::string> kWords{"bin",
                                      "lay",
                                      "place",
                                      "set",
                                      "blue",
                                      "red",
                                      "white",
                                      "at",
                                      "by",
                                      "in",
                                      "with",
                                      "two",
                                      "three",
                                      "four",
                                      "five",
                                      "now",
                                      "please",
                                      "soon"};

const std::map<std::string, std::string> kTexts{{"bbaf2n", "bin blue at f two now"},
                                                {"brbk7n", "bin red by k seven now"},
                                                {"id2_vcd_swwp2s", "set white with p two soon"},
                                                {"lbax4n", "lay blue at x four now"},
                                                {"pwij3p", "place white in j three please"},
                                                {"sbwe5n", "set blue with e five now"}};

TEST(GridCorpus, IsBuiltFromTheSixClips) {
  const auto data = testing_corpus::test_data();
  if (data.empty() || !std::filesystem::exists(data / "clips" / "bbaf2n.mpg")) {
    GTEST_SKIP() << "BIMODAL_TEST_DATA does not name a folder with clips/bbaf2n.mpg";
  }
  const WrittenFiles folder;
  BuildRequest request{.folder = folder / "grid", .licence = "CC BY 4.0"};
  const Dictionary dictionary{Dictionary::installed()};
  for (const auto& word : kWords) {
    request.list.words.push_back({word, dictionary.pronunciations(word).front()});
  }
  for (const auto& [name, text] : kTexts) {
    // Alone, so that the word times beside some clips are not used.
    const auto clip = folder / (name + ".mpg");
    std::filesystem::copy_file(data / "clips" / (name + ".mpg"), clip);
    request.recordings.push_back(clip);
    folder.write(name + ".txt", text);
  }
  const auto report = build_corpus(request);
  EXPECT_THAT(report.findings, IsEmpty());
  const auto& corpus = report.corpus;

  std::set<std::string> found;
  for (const auto& word : word_list_of(corpus).words) found.insert(word.spelling);
  EXPECT_EQ(found, (std::set<std::string>{kWords.begin(), kWords.end()}));

  std::vector<Duration> apart;
  for (const auto& item : corpus.items) {
    const auto& recording = corpus.recordings[item.recording];
    EXPECT_GE(item.phones.front().start - item.start, 50ms) << item.name;
    EXPECT_GE(item.end - item.phones.back().end(), 50ms) << item.name;
    const auto name = std::filesystem::path{recording.file}.stem().string();
    const auto by_hand = data / "lips" / (name + ".TextGrid");
    if (!std::filesystem::exists(by_hand)) continue;
    const auto labels = read_labels(by_hand);
    const auto reference = utterance_of(*phone_tier(labels), labels.end);
    for (const auto& timed : item.phones) {
      auto nearest = Duration::max();
      for (const auto& other : reference.phones) {
        nearest = std::min(nearest, std::chrono::abs(other.start - timed.start));
      }
      apart.push_back(nearest);
    }
  }
  if (!apart.empty()) {
    std::ranges::sort(apart);
    EXPECT_LE(apart[apart.size() / 2], 20ms);
    EXPECT_LE(apart[apart.size() * 9 / 10], 60ms);
  }

  const auto check = check_corpus(corpus, request.list.words);
  EXPECT_EQ(check.errors(), 0U);
  EXPECT_THAT(check.missing, IsEmpty());
  for (const auto& recording : check.recordings) {
    EXPECT_NEAR(recording.media->picture->frame_rate.count(), 25.0, 1e-6);
    EXPECT_LE(std::chrono::abs(*recording.sound_begins_later), 1ms);
    EXPECT_LT(*recording.sound_ends_later, 0ms);
    EXPECT_GT(*recording.sound_ends_later, -60ms);
  }
  // Once for a recording, not for each of its items.
  const auto told = std::ranges::count_if(check.recordings, [](const auto& recording) {
    return std::ranges::any_of(recording.findings, [](const auto& finding) {
      return finding.find("a neighbouring word within 50 ms") != std::string::npos;
    });
  });
  EXPECT_EQ(told, std::ssize(check.recordings));
}

}  // namespace
}  // namespace bimodal
