#include "stimuli/corpus/build_corpus.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/corpus/check_corpus.hpp"
#include "stimuli/corpus/contact_sheet.hpp"
#include "stimuli/corpus/word_list_of.hpp"
#include "stimuli/labels/label_file.hpp"
#include "stimuli/picture/image.hpp"
#include "tests/stimuli/corpus/build_corpus_fixture.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;
using testing_corpus::all_of;
using testing_corpus::apart;
using testing_corpus::BuildCorpus;
using testing_corpus::item;
using testing_corpus::list_of;
using testing_corpus::Reading;

const std::vector<std::string> kWords{"stone",
                                      "like",
                                      "ship",
                                      "green",
                                      "food",
                                      "bath",
                                      "clown",
                                      "queen",
                                      "sharp",
                                      "mouth",
                                      "jazz",
                                      "spoon"};

TEST_F(BuildCorpus, FindsWordsCoughsTakesMissingAndWrongWords) {
  Reading reading{*voice_};
  reading.pause(0.5);
  std::vector<SpeechInterval> said(kWords.size());
  SpeechInterval cough;
  SpeechInterval first_take;
  SpeechInterval wrong;
  for (std::size_t i = 0; i < kWords.size(); ++i) {
    if (kWords[i] == "bath") continue;  // missing
    if (kWords[i] == "queen") {
      wrong = reading.say("strawberry");
    } else {
      said[i] = reading.say(kWords[i]);
    }
    reading.pause(0.3);
    if (kWords[i] == "like") {
      cough = reading.cough(0.3);
      reading.pause(0.5);
    }
    if (kWords[i] == "clown") {
      first_take = said[i];
      said[i] = reading.say("clown");
      reading.pause(0.3);
    }
  }
  write_wav(folder_ / "reading.wav", reading.sound());

  const auto report = build_corpus(request("reading.wav", kWords));
  const auto& corpus = report.corpus;
  for (std::size_t i = 0; i < kWords.size(); ++i) {
    if (kWords[i] == "bath" || kWords[i] == "queen") {
      EXPECT_EQ(find_item(corpus, kWords[i]), nullptr) << kWords[i];
      continue;
    }
    const auto& found = item(corpus, kWords[i]);
    EXPECT_LE(apart(found, said[i]), 80ms) << kWords[i];
    EXPECT_GE(found.phones.front().start - found.start, 50ms);
    EXPECT_GE(found.end - found.phones.back().end(), 50ms);
  }
  EXPECT_THAT(item(corpus, "clown-2").doubt, HasSubstr("another take"));
  EXPECT_LE(apart(item(corpus, "clown-2"), first_take), 80ms);
  const auto findings = all_of(report.findings);
  EXPECT_THAT(findings, HasSubstr("of the list not found"));
  EXPECT_THAT(findings, HasSubstr("bath"));
  EXPECT_THAT(
      findings,
      HasSubstr(
          fmt::format("{:.1f}", std::chrono::duration<double>{cough.start}.count()).substr(0, 3)));
  EXPECT_THAT(findings, HasSubstr("none of the words"));
  EXPECT_FALSE(has_errors(report.findings));

  std::vector<Diagnostic> diagnostics;
  const auto read = read_corpus(folder_ / "corpus", diagnostics);
  EXPECT_THAT(diagnostics, IsEmpty());
  EXPECT_EQ(read.items.size(), corpus.items.size());
  EXPECT_EQ(sha256_of_file(media_file(read, 0)), sha256_of_file(folder_ / "reading.wav"));
}

TEST_F(BuildCorpus, IsFollowedByACheckWithoutErrors) {
  read_aloud({kWords.begin(), kWords.begin() + 6}, "reading.wav");
  const auto list = list_of(kWords);
  const auto report = build_corpus(request("reading.wav", kWords));
  const auto check = check_corpus(report.corpus, list.words);
  EXPECT_EQ(check.errors(), 0U);
  ASSERT_TRUE(check.median_level.has_value());
  for (const auto& found : check.items) {
    EXPECT_TRUE(found.sound.has_value());
    EXPECT_FALSE(found.frames.has_value());
    EXPECT_GE(found.before, 50ms);
  }
  EXPECT_GE(check.missing.size(), 6U);
  const auto sheet = draw_contact_sheet(report.corpus, folder_ / "sheet.png");
  ASSERT_EQ(sheet.files.size(), 1U);
  EXPECT_GT(read_png(sheet.files[0]).height, 100U);
  EXPECT_THAT(word_list_of(report.corpus).name, "corpus");
}

TEST_F(BuildCorpus, DoubtsSilenceLabelledAsAWordOfRunningSpeech) {
  const auto said = read_aloud({"place", "white", "spoon"}, "reading.wav");
  const Labels labels{.end = said.back().end + 300ms,
                      .tiers = {{"words",
                                 {{said[0].start, said[0].end, "place"},
                                  {said[0].end, said[0].end + 60ms, "with"},
                                  {said[0].end + 60ms, said[0].end + 90ms, "at"},
                                  {said[1].start, said[1].end, "white"},
                                  {said[2].start, said[2].end, "spoon"},
                                  {said[2].end + 100ms, said[2].end + 280ms, "queen"}}},
                                {"phones",
                                 {{said[0].start, said[0].end, "P"},
                                  {said[0].end, said[0].end + 60ms, "W"},
                                  {said[0].end + 60ms, said[0].end + 90ms, "AE"},
                                  {said[1].start, said[1].end, "W"},
                                  {said[2].start, said[2].end, "S"},
                                  {said[2].end + 100ms, said[2].end + 280ms, "K"}}}}};
  write_labels(folder_ / "reading.TextGrid", labels);
  const auto corpus = build_corpus(request("reading.wav", {"white", "spoon", "queen"})).corpus;
  EXPECT_THAT(item(corpus, "queen").doubt, HasSubstr("weaker than the talker's other words"));
  EXPECT_THAT(item(corpus, "spoon").doubt, testing::Not(HasSubstr("weaker")));
}

TEST_F(BuildCorpus, TakesWordTiersAndAlignsWithinThem) {
  const std::vector<std::string> words{"stone", "like"};
  const auto said = read_aloud(words, "reading.wav");
  const Labels labels{
      .end = said.back().end + 200ms,
      .tiers = {{"Words",
                 {{said[0].start, said[0].end, "Stone"}, {said[1].start, said[1].end, "like"}}}}};
  write_labels(folder_ / "reading.TextGrid", labels);
  const auto corpus = build_corpus(request("reading.wav", words)).corpus;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto& found = item(corpus, words[i]);
    EXPECT_LE(apart(found, said[i]), 1us);
    EXPECT_EQ(pronunciation_of(found), list_of({words[i]}).words.front().phones);
    EXPECT_THAT(found.doubt, IsEmpty());
  }
}

TEST_F(BuildCorpus, UsesWordsAndPhonesAsTheyStand) {
  read_aloud({"stone"}, "reading.wav");
  // Not what is said, but the hand wins.
  const Labels labels{
      .end = 1s,
      .tiers = {{"words", {{400ms, 700ms, "like"}}},
                {"phones", {{400ms, 450ms, "l"}, {450ms, 600ms, "ay1"}, {600ms, 700ms, "k"}}}}};
  write_labels(folder_ / "reading.TextGrid", labels);
  const auto corpus = build_corpus(request("reading.wav", {"stone", "like"})).corpus;
  ASSERT_EQ(corpus.items.size(), 1U);
  EXPECT_EQ(corpus.items[0].word, "like");
  EXPECT_EQ(corpus.items[0].phones[1], (TimedPhone{Phone::AY, 450ms, 150ms}));
}

TEST_F(BuildCorpus, DoubtsAWordWhereItsTiersDisagree) {
  read_aloud({"stone"}, "reading.wav");
  const auto doubt_of = [&](const Label& word, const Label& last_phone) {
    std::filesystem::remove_all(folder_ / "corpus");
    const Labels labels{
        .end = 1s,
        .tiers = {{"words", {word}},
                  {"phones", {{400ms, 450ms, "l"}, {450ms, 600ms, "ay"}, last_phone}}}};
    write_labels(folder_ / "reading.TextGrid", labels);
    const auto corpus = build_corpus(request("reading.wav", {"like", "ship"})).corpus;
    EXPECT_EQ(corpus.items.size(), 1U);
    EXPECT_GE(corpus.items.front().phones.size(), 2U);
    return corpus.items.front().doubt;
  };
  const Label last{600ms, 700ms, "k"};
  EXPECT_THAT(doubt_of({400ms, 700ms, "like"}, last), IsEmpty());
  EXPECT_THAT(doubt_of({400ms, 704ms, "like"}, last), IsEmpty());
  EXPECT_THAT(doubt_of({380ms, 700ms, "like"}, last), HasSubstr("make both tiers agree"));
  EXPECT_THAT(doubt_of({400ms, 600ms, "like"}, last), HasSubstr("the phone K (0.600 to 0.700 s)"));
  EXPECT_THAT(doubt_of({400ms, 700ms, "like"}, {600ms, 900ms, "k"}),
              HasSubstr("its phones are 0.400 to 0.900 s"));
  EXPECT_THAT(doubt_of({400ms, 700ms, "ship"}, last),
              HasSubstr("its phones are L AY K, those of the list SH IH P"));
}

TEST_F(BuildCorpus, JudgesTheOneWordOfATakeAsAWordThatStandsAlone) {
  read_aloud({"stone"}, "take.wav");
  auto wanted = request("take.wav", {"stone", "ship"});
  wanted.texts["take"] = {"ship"};
  wanted.texts["tkae"] = {"ship"};
  const auto report = build_corpus(wanted);
  ASSERT_EQ(report.corpus.items.size(), 1U);
  EXPECT_THAT(report.corpus.items.front().doubt, HasSubstr("hardly fits"));
  EXPECT_THAT(all_of(report.findings), HasSubstr("'tkae', but no such recording"));
}

TEST_F(BuildCorpus, LeavesNoFolderIfNothingCouldBeUsed) {
  folder_.write("text.wav", "this is no sound");
  EXPECT_EQ(build_corpus(request("text.wav", {"stone"})).corpus.recordings.size(), 0U);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "corpus"));
}

TEST_F(BuildCorpus, TakesListedWordsOutOfKnownRunningSpeech) {
  const auto said = read_aloud({"place", "white", "with", "spoon"}, "reading.wav");
  auto wanted = request("reading.wav", {"white", "spoon", "queen"});
  folder_.write("reading.txt", "Place white with spoon.\n");
  const auto report = build_corpus(wanted);
  ASSERT_EQ(report.corpus.items.size(), 2U);
  EXPECT_LE(apart(item(report.corpus, "white"), said[1]), 80ms);
  EXPECT_THAT(report.notes, Contains(HasSubstr("place, with")));
  EXPECT_EQ(std::ranges::count_if(report.findings,
                                  [](const auto& finding) {
                                    return finding.finding.find("queen") != std::string::npos;
                                  }),
            0);
}

TEST_F(BuildCorpus, TellsOfRecordingsThatCannotBeUsedAndTakesTheOthers) {
  read_aloud({"stone", "like"}, "good.wav");
  write_wav(folder_ / "silent.wav", {Hertz{16'000}, std::vector<float>(32'000)});
  folder_.write("text.wav", "this is no sound");
  folder_.write("empty.wav", "");
  auto wanted = request("good.wav", {"stone", "like"});
  for (const char* const name : {"silent.wav", "text.wav", "empty.wav", "missing.wav"}) {
    wanted.recordings.push_back(folder_ / name);
  }
  const auto report = build_corpus(wanted);
  EXPECT_EQ(report.corpus.items.size(), 2U);
  EXPECT_EQ(std::ranges::count(report.findings, Severity::Error, &Diagnostic::severity), 4);
  EXPECT_THAT(all_of(report.findings), HasSubstr("there is no speech"));
}

TEST_F(BuildCorpus, RefusesAnEmptyListAndRecordingsOfOneName) {
  read_aloud({"stone"}, "reading.wav");
  auto wanted = request("reading.wav", {});
  EXPECT_THAT([&] { static_cast<void>(build_corpus(wanted)); },
              ThrowsMessage<Error>(HasSubstr("list of words is empty")));
  wanted = request("reading.wav", {"stone"});
  wanted.recordings.push_back(folder_ / "other" / "reading.mp4");
  EXPECT_THAT([&] { static_cast<void>(build_corpus(wanted)); },
              ThrowsMessage<Error>(HasSubstr("two recordings are called 'reading'")));
}

TEST_F(BuildCorpus, ListsEverythingDoubtfulInAReadingOfOtherWords) {
  read_aloud({"strawberry", "telephone", "umbrella", "hippopotamus"}, "reading.wav");
  const auto report = build_corpus(request("reading.wav", {"ape", "zoo", "fish", "chalk"}));
  for (const auto& found : report.corpus.items)
    EXPECT_THAT(found.doubt, testing::Not(IsEmpty())) << found.word;
}

TEST_F(BuildCorpus, CutsVideo) {
  if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no ffmpeg";
  const std::vector<std::string> words{"stone", "like", "ship", "green"};
  const auto said = read_aloud(words, "sound.wav");
  const auto command = fmt::format(
      "ffmpeg -v error -f lavfi -i testsrc=size=160x120:rate=25 -i '{}' -shortest -c:v libx264 "
      "-c:a "
      "aac '{}' 2>/dev/null",
      (folder_ / "sound.wav").string(),
      (folder_ / "reading.mp4").string());
  if (std::system(command.c_str()) != 0) GTEST_SKIP() << "ffmpeg cannot write H.264 with AAC";
  const auto report = build_corpus(request("reading.mp4", words));
  ASSERT_EQ(report.corpus.items.size(), words.size()) << all_of(report.findings);
  for (std::size_t i = 0; i < words.size(); ++i) {
    EXPECT_LE(apart(item(report.corpus, words[i]), said[i]), 80ms) << words[i];
  }
  EXPECT_TRUE(std::filesystem::exists(folder_ / "corpus" / "sound" / "reading.wav"));
  const auto check = check_corpus(report.corpus);
  EXPECT_EQ(check.errors(), 0U);
  for (std::size_t i = 0; i < check.items.size(); ++i) {
    const auto& length = report.corpus.items[i].end - report.corpus.items[i].start;
    ASSERT_TRUE(check.items[i].frames.has_value());
    EXPECT_NEAR(
        static_cast<double>(check.items[i].frames->count), static_cast<double>(length / 40ms), 2.0);
    EXPECT_EQ(check.items[i].frames->uneven, 0U);
  }
  EXPECT_GT(read_png(draw_contact_sheet(report.corpus, folder_ / "sheet.png").files.at(0)).height,
            150U);
}

TEST_F(BuildCorpus, IsCheckedForChangedAndMissingFiles) {
  read_aloud({"stone", "like"}, "reading.wav");
  const auto corpus = build_corpus(request("reading.wav", {"stone", "like"})).corpus;
  std::filesystem::remove(media_file(corpus, 0));
  EXPECT_GT(check_corpus(corpus).errors(), 0U);
  read_aloud({"ship", "green"}, "other.wav");
  std::filesystem::copy_file(folder_ / "other.wav", media_file(corpus, 0));
  EXPECT_THAT(check_corpus(corpus).recordings[0].errors, Contains(HasSubstr("SHA-256")));
}

}  // namespace
}  // namespace bimodal
