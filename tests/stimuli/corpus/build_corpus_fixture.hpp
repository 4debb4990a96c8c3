#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "stimuli/corpus/build_corpus.hpp"
#include "stimuli/words/dictionary.hpp"
#include "tests/stimuli/corpus/corpus_folder.hpp"

namespace bimodal::testing_corpus {

inline WordList list_of(const std::vector<std::string>& spellings) {
  const Dictionary dictionary{Dictionary::installed()};
  WordList list{.name = "test"};
  for (const auto& spelling : spellings) {
    list.words.push_back({spelling, dictionary.pronunciations(spelling).front()});
  }
  return list;
}

inline std::string all_of(const std::vector<Diagnostic>& findings) {
  std::string text;
  for (const auto& finding : findings) text += describe(finding) + "\n";
  return text;
}

inline const CorpusItem& item(const Corpus& corpus, const std::string& name) {
  const auto found = std::ranges::find(corpus.items, name, &CorpusItem::name);
  if (found == corpus.items.end()) throw Error{"there is no item " + name};
  return *found;
}

/// Within an item's phones and the time at which the voice has said the word.
inline Duration apart(const CorpusItem& item, const SpeechInterval& said) {
  return std::max(std::chrono::abs(item.phones.front().start - said.start),
                  std::chrono::abs(item.phones.back().end() - said.end));
}

class BuildCorpus : public testing::Test {
 protected:
  void SetUp() override {
    try {
      voice_.emplace("kal");
      static_cast<void>(Dictionary::installed());
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }

  /// Reads the words one after the other, 0.5 s apart, and writes them.
  std::vector<SpeechInterval> read_aloud(const std::vector<std::string>& words,
                                         const std::string& file) {
    Reading reading{*voice_};
    std::vector<SpeechInterval> said;
    reading.pause(0.4);
    for (const auto& word : words) {
      said.push_back(reading.say(word));
      reading.pause(0.3);
    }
    write_wav(folder_ / file, reading.sound());
    return said;
  }

  BuildRequest request(const std::string& file, const std::vector<std::string>& words) {
    return {.folder = folder_ / "corpus",
            .recordings = {folder_ / file},
            .list = list_of(words),
            .talker = "kal"};
  }

  WrittenFiles folder_;
  std::optional<synth::Voice> voice_;
};

}  // namespace bimodal::testing_corpus
