// The word lists that the project ships, held against the dictionary and against their own rule.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/words/dictionary.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal {
namespace {

using ::testing::IsEmpty;

constexpr std::string_view kFolder = "stimuli/assets/words/";

std::filesystem::path shipped(std::string_view file) {
  return asset(std::string{kFolder} + std::string{file});
}

const WordList& words(const std::string& file) {
  static std::map<std::string, WordList> lists;
  if (!lists.contains(file)) {
    std::vector<Diagnostic> diagnostics;
    lists[file] = read_word_list(shipped(file), diagnostics);
    EXPECT_THAT(diagnostics, IsEmpty()) << file;
  }
  return lists.at(file);
}

const WordList& main_list() {
  return words("monosyllables-414.json");
}

const WordList& practice() {
  return words("practice-12.json");
}

const WordList& familiar() {
  return words("familiar-monosyllables.json");
}

const Dictionary& dictionary() {
  static const Dictionary installed{Dictionary::installed()};
  return installed;
}

std::size_t vowel_at(const Pronunciation& phones) {
  return static_cast<std::size_t>(std::ranges::find_if(phones, is_vowel) - phones.begin());
}

/// The five things that the rule counts, as proportions.csv names them.
std::map<std::string, std::string> features(const Word& word) {
  const std::size_t vowel = vowel_at(word.phones);
  const std::size_t after = word.phones.size() - vowel - 1;
  return {{"initial", vowel == 0 ? "-" : std::string{symbol(word.phones.front())}},
          {"onset size", std::to_string(vowel)},
          {"vowel", std::string{symbol(word.phones[vowel])}},
          {"coda size", std::to_string(after)},
          {"final", after == 0 ? "-" : std::string{symbol(word.phones.back())}}};
}

TEST(Monosyllables, Are414DifferentWords) {
  std::set<std::string> spellings;
  for (const auto& word : main_list().words) spellings.insert(word.spelling);
  EXPECT_EQ(main_list().words.size(), 414U);
  EXPECT_EQ(spellings.size(), 414U);
}

TEST(Monosyllables, HaveTheDictionarysOnlyPronunciationAndOneSyllable) {
  for (const WordList* list : {&main_list(), &practice(), &familiar()}) {
    for (const auto& [spelling, phones, seen, articulation] : list->words) {
      ASSERT_EQ(dictionary().pronunciations(spelling).size(), 1U) << spelling;
      EXPECT_EQ(dictionary().pronunciations(spelling)[0], phones) << spelling;
      EXPECT_TRUE(is_one_syllable(phones)) << spelling;
      EXPECT_TRUE(std::ranges::all_of(spelling, [](char c) { return c >= 'a' && c <= 'z'; }));
    }
  }
}

TEST(Monosyllables, SoundLikeNoOtherWordOfTheirsOrOfThePracticeWords) {
  std::map<Pronunciation, std::string> heard;
  for (const WordList* list : {&main_list(), &practice()}) {
    for (const auto& [spelling, phones, seen, articulation] : list->words) {
      EXPECT_TRUE(heard.emplace(phones, spelling).second) << spelling << " = " << heard[phones];
    }
  }
}

TEST(Monosyllables, SoundLikeNoOtherFamiliarMonosyllable) {
  std::map<Pronunciation, int> count;
  std::set<std::string> answers;
  for (const auto& [spelling, phones, seen, articulation] : familiar().words) {
    ++count[phones];
    answers.insert(spelling);
  }
  for (const WordList* list : {&main_list(), &practice()}) {
    for (const auto& [spelling, phones, seen, articulation] : list->words) {
      EXPECT_TRUE(answers.contains(spelling)) << spelling;
      EXPECT_EQ(count[phones], 1) << spelling;
    }
  }
}

TEST(Monosyllables, HaveEveryConsonantThatEnglishAllowsThereAndEveryVowelOfTheDictionary) {
  std::set<Phone> initial;
  std::set<Phone> final;
  std::set<Phone> vowels;
  for (const auto& [spelling, phones, seen, articulation] : main_list().words) {
    initial.insert(phones.front());
    final.insert(phones.back());
    vowels.insert(phones[vowel_at(phones)]);
  }
  for (const Phone phone : all_phones().subspan(1)) {
    using enum Phone;
    if (is_vowel(phone)) {
      EXPECT_EQ(vowels.contains(phone), phone != AX) << symbol(phone);
      continue;
    }
    const std::set<Phone> never_first{NG, ZH, WH};
    const std::set<Phone> never_last{HH, W, WH, Y};
    EXPECT_EQ(initial.contains(phone), !never_first.contains(phone)) << symbol(phone);
    EXPECT_EQ(final.contains(phone), !never_last.contains(phone)) << symbol(phone);
  }
}

TEST(Monosyllables, DifferByLessThanOneWordFromTheProportionsOfEnglish) {
  struct Row {
    double english = 0.0;
    int quota = 0;
    int chosen = 0;
  };

  std::map<std::string, std::map<std::string, Row>> table;
  std::ifstream file{shipped("proportions.csv")};
  std::string line;
  std::getline(file, line);
  ASSERT_EQ(line, "margin,value,english,quota,chosen");
  while (std::getline(file, line)) {
    std::istringstream cells{line};
    std::string margin;
    std::string value;
    std::getline(cells, margin, ',');
    std::getline(cells, value, ',');
    Row& row = table[margin][value];
    char comma = 0;
    cells >> row.english >> comma >> row.quota >> comma >> row.chosen;
    ASSERT_TRUE(cells) << line;
  }
  std::map<std::string, std::map<std::string, int>> counted;
  for (const auto& word : main_list().words) {
    for (const auto& [margin, value] : features(word)) ++counted[margin][value];
  }
  ASSERT_EQ(table.size(), 5U);
  for (const auto& [margin, rows] : table) {
    double population = 0.0;
    int quotas = 0;
    for (const auto& [value, row] : rows) {
      population += row.english;
      quotas += row.quota;
    }
    EXPECT_EQ(population, 2862.0) << margin;
    EXPECT_EQ(quotas, 414) << margin;
    for (const auto& [value, row] : rows) {
      EXPECT_EQ(counted[margin][value], row.chosen) << margin << ' ' << value;
      EXPECT_LT(std::abs(row.chosen - 414.0 * row.english / population), 1.0)
          << margin << ' ' << value;
    }
  }
}

TEST(Monosyllables, ThePracticeWordsAreTwelveOutsideTheList) {
  std::set<std::string> spellings;
  for (const auto& word : main_list().words) spellings.insert(word.spelling);
  for (const auto& word : practice().words) {
    EXPECT_TRUE(spellings.insert(word.spelling).second) << word.spelling;
  }
  EXPECT_EQ(practice().words.size(), 12U);
}

// Lists of different experiments, which one person may take part in both.
TEST(Monosyllables, OfTheCompressedSpeechExperimentAre420AndInNoOtherList) {
  const auto& compressed = words("monosyllables-420.json");
  EXPECT_EQ(compressed.words.size(), 420U);
  std::set<std::string> others;
  for (const WordList* list : {&main_list(), &practice()}) {
    for (const auto& word : list->words) others.insert(word.spelling);
  }
  for (const auto& word : compressed.words) {
    EXPECT_FALSE(others.contains(word.spelling)) << word.spelling;
    ASSERT_EQ(dictionary().pronunciations(word.spelling).size(), 1U) << word.spelling;
    EXPECT_EQ(dictionary().pronunciations(word.spelling)[0], word.phones) << word.spelling;
    EXPECT_TRUE(is_one_syllable(word.phones)) << word.spelling;
  }
}

TEST(Monosyllables, TheToolWritesTheSameBytesAgain) {
  const auto folder = std::filesystem::path{::testing::TempDir()} / "bimodal-select-words";
  std::filesystem::create_directories(folder);
  const auto tool = asset("tools/words/select_words.py");
  const std::string command =
      "python3 -B '" + tool.string() + "' '" + folder.string() + "' > /dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0)
      << "needs python3, wamerican-small and pocketsphinx-en-us";
  for (const auto* const file : {"monosyllables-414.json",
                                 "monosyllables-420.json",
                                 "practice-12.json",
                                 "familiar-monosyllables.json",
                                 "proportions.csv"}) {
    EXPECT_EQ(sha256_of_file(folder / file), sha256_of_file(shipped(file))) << file;
  }
}

}  // namespace
}  // namespace bimodal
