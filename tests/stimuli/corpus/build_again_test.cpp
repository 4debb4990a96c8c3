// What a build keeps of the corpus that is there, and what it tells of it.
#include <chrono>
#include <filesystem>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/labels/label_file.hpp"
#include "tests/stimuli/corpus/build_corpus_fixture.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_corpus::all_of;
using testing_corpus::BuildCorpus;
using testing_corpus::item;

TEST_F(BuildCorpus, KeepsLabelsThatSomebodyHasCorrected) {
  const std::vector<std::string> words{"stone", "like", "ship", "green"};
  read_aloud(words, "reading.wav");
  const auto wanted = request("reading.wav", words);
  const auto first = build_corpus(wanted);
  const auto file = folder_ / "corpus" / "labels" / "reading.TextGrid";
  auto labels = read_labels(file);
  // The edge between the first word's first two phones, 15 ms later.
  const auto edge = item(first.corpus, "stone").phones[1].start;
  for (auto& tier : labels.tiers) {
    for (auto& label : tier.labels) {
      if (std::chrono::abs(label.start - edge) < 1ms) label.start += 15ms;
      if (std::chrono::abs(label.end - edge) < 1ms) label.end += 15ms;
    }
  }
  write_labels(file, labels);
  const auto digest = sha256_of_file(file);

  for (int i = 0; i < 2; ++i) {
    const auto again = build_corpus(wanted);
    const auto moved = item(again.corpus, "stone").phones[1].start;
    EXPECT_LE(std::chrono::abs(moved - edge - 15ms), 1us);
    EXPECT_EQ(sha256_of_file(file), digest);
    EXPECT_EQ(again.corpus.items.size(), first.corpus.items.size());
  }
}

TEST_F(BuildCorpus, OverwritesLabelsThatNobodyHasTouched) {
  const std::vector<std::string> words{"stone", "like"};
  read_aloud(words, "reading.wav");
  const auto wanted = request("reading.wav", words);
  const auto first = build_corpus(wanted);
  const auto second = build_corpus(wanted);
  EXPECT_EQ(first.corpus.items, second.corpus.items);
}

TEST_F(BuildCorpus, KeepsTheVerdictOnAnItemThatIsTheSame) {
  const std::vector<std::string> words{"stone", "like", "ship"};
  read_aloud({"stone", "like", "like", "ship"}, "reading.wav");
  const auto wanted = request("reading.wav", words);
  auto corpus = build_corpus(wanted).corpus;
  EXPECT_THAT(item(corpus, "like-2").doubt, HasSubstr("another take"));
  for (auto& each : corpus.items) each.accepted = std::exchange(each.doubt, {});
  write_corpus(corpus);
  for (int i = 0; i < 2; ++i) {
    for (const auto& each : build_corpus(wanted).corpus.items) EXPECT_THAT(each.doubt, IsEmpty());
  }
}

TEST_F(BuildCorpus, DoubtsWhatHasBecomeDoubtfulSince) {
  const std::vector<std::string> words{"stone", "like"};
  read_aloud(words, "reading.wav");
  const auto wanted = request("reading.wav", words);
  EXPECT_THAT(item(build_corpus(wanted).corpus, "stone").doubt, IsEmpty());
  const auto file = folder_ / "corpus" / "labels" / "reading.TextGrid";
  auto labels = read_labels(file);
  for (auto& tier : labels.tiers) {
    for (auto& label : tier.labels) {
      if (label.text == "stone") label.end -= 30ms;
    }
  }
  write_labels(file, labels);
  for (int i = 0; i < 2; ++i) {
    EXPECT_THAT(item(build_corpus(wanted).corpus, "stone").doubt,
                HasSubstr("make both tiers agree"));
  }
}

TEST_F(BuildCorpus, DoubtsTheEarlierItemsOfARecordingThatCannotBeBuiltAgain) {
  read_aloud({"stone", "like"}, "reading.wav");
  const auto wanted = request("reading.wav", {"stone", "like"});
  static_cast<void>(build_corpus(wanted));
  write_labels(folder_ / "corpus" / "labels" / "reading.TextGrid",
               {.end = 1s, .tiers = {{"words", {{0ms, 100ms, "stone"}}}, {"phones", {}}}});
  const auto report = build_corpus(wanted);
  EXPECT_TRUE(has_errors(report.findings));
  EXPECT_EQ(report.corpus.items.size(), 2U);
  for (const auto& each : report.corpus.items) {
    EXPECT_THAT(each.doubt, HasSubstr("could not be built again"));
  }
}

TEST_F(BuildCorpus, TellsOfANameThatStandsForAnotherSound) {
  const std::vector<std::string> words{"stone", "like"};
  read_aloud({"stone", "stone", "like"}, "reading.wav");
  const auto wanted = request("reading.wav", words);
  const auto first = build_corpus(wanted).corpus;
  const auto file = folder_ / "corpus" / "labels" / "reading.TextGrid";
  auto labels = read_labels(file);
  const auto kept = item(first, "stone").phones.front().start;
  for (auto& tier : labels.tiers) {
    for (auto& label : tier.labels) {
      const bool meant = label.text == "stone" && std::chrono::abs(label.start - kept) < 1ms;
      if (meant) label.text = "like";
    }
  }
  write_labels(file, labels);
  EXPECT_THAT(all_of(build_corpus(wanted).findings),
              HasSubstr("another sound goes by the name of an earlier one: stone ("));
}

TEST_F(BuildCorpus, NamesTheWordsThatAreGone) {
  const std::vector<std::string> words{"stone", "like"};
  read_aloud(words, "reading.wav");
  const auto wanted = request("reading.wav", words);
  EXPECT_THAT(build_corpus(wanted).findings, IsEmpty());
  const auto file = folder_ / "corpus" / "labels" / "reading.TextGrid";
  auto labels = read_labels(file);
  for (auto& tier : labels.tiers) {
    for (auto& label : tier.labels) {
      if (label.text == "stone") label.text = "stine";
    }
  }
  write_labels(file, labels);
  EXPECT_THAT(all_of(build_corpus(wanted).findings),
              HasSubstr("1 word that the corpus had is gone: stone"));
}

TEST_F(BuildCorpus, TellsThatTheRecordingHasChanged) {
  read_aloud({"stone", "like"}, "reading.wav");
  auto wanted = request("reading.wav", {"stone", "like"});
  static_cast<void>(build_corpus(wanted));
  read_aloud({"like", "stone"}, "other.wav");
  std::filesystem::remove(folder_ / "corpus" / "media" / "reading.wav");
  std::filesystem::copy_file(folder_ / "other.wav", folder_ / "corpus" / "media" / "reading.wav");
  wanted.recordings.clear();
  EXPECT_THAT(all_of(build_corpus(wanted).findings), HasSubstr("it is not the recording"));
  EXPECT_THAT(all_of(build_corpus(wanted).findings),
              testing::Not(HasSubstr("is not the recording")));
}

TEST_F(BuildCorpus, AddsRecordingsToACorpusThatIsThere) {
  read_aloud({"stone", "like"}, "one.wav");
  read_aloud({"stone", "ship"}, "two.wav");
  static_cast<void>(build_corpus(request("one.wav", {"stone", "like"})));
  const auto corpus = build_corpus(request("two.wav", {"stone", "ship"})).corpus;
  EXPECT_EQ(corpus.recordings.size(), 2U);
  EXPECT_EQ(item(corpus, "stone-2").recording, 1U);
  auto again = request("two.wav", {"stone", "like", "ship"});
  again.recordings.clear();
  EXPECT_EQ(build_corpus(again).corpus.items.size(), 4U);
}

}  // namespace
}  // namespace bimodal
