#include "protocols/reading/judge_repertoire.hpp"

#include <algorithm>
#include <set>

#include <fmt/ranges.h>

#include "stimuli/base/counted.hpp"

namespace bimodal::protocols {

namespace {

constexpr std::size_t kWordsNamed = 5;  ///< in a message about many

/// What is to be said of a corpus that has to say some words, each once.
class Repertoire {
 public:
  explicit Repertoire(const Corpus& corpus) : corpus_{corpus} {}

  void need(const std::string& word, const Pronunciation& phones) {
    if (const auto* const item = find_item(corpus_, word)) {
      talkers_.insert(corpus_.recordings.at(item->recording).talker);
      const bool rests = std::ranges::any_of(
          item->phones, [](const TimedPhone& timed) { return timed.phone == Phone::Rest; });
      const auto said = pronunciation_of(*item);
      const auto one_word = word.find(' ') == std::string::npos;
      if (said != phones || (rests && one_word)) {
        different_.insert(fmt::format("{} ({}, in the list {})", word, spell(said), spell(phones)));
      }
      return;
    }
    const bool doubtful = std::ranges::any_of(
        corpus_.items, [&](const CorpusItem& item) { return item.word == word; });
    auto& words = doubtful ? doubtful_ : absent_;
    if (std::ranges::find(words, word) == words.end()) words.push_back(word);
  }

  void tell(const std::string& pointer, Findings& findings) const {
    if (!different_.empty()) {
      findings.warning(
          pointer,
          fmt::format("the corpus \"{}\" has other phones, or a pause within, for {}: {}",
                      corpus_.name,
                      counted(different_.size(), "word"),
                      named({different_.begin(), different_.end()})),
          "answers are scored by the recording's phones; mend its labels if they are wrong");
    }
    if (!absent_.empty()) {
      findings.error(pointer,
                     fmt::format("the corpus \"{}\" lacks {}: {}",
                                 corpus_.name,
                                 counted(absent_.size(), "word"),
                                 named(absent_)),
                     "record them, or take these words out of the list");
    }
    if (!doubtful_.empty()) {
      findings.error(pointer,
                     fmt::format("the corpus \"{}\" has only doubtful items of {}: {}",
                                 corpus_.name,
                                 counted(doubtful_.size(), "word"),
                                 named(doubtful_)),
                     "look at them (`bimodal corpus check`), then `bimodal corpus accept`");
    }
  }

  /// Once for a corpus, however many conditions use it.
  void tell_of_talkers(const std::string& pointer, Findings& findings) const {
    if (talkers_.size() < 2) return;
    findings.warning(pointer,
                     fmt::format("the words come from {} talkers of the corpus \"{}\": {}",
                                 talkers_.size(),
                                 corpus_.name,
                                 named({talkers_.begin(), talkers_.end()})),
                     "differences of talkers mix with those of words; give each talker a corpus");
  }

 private:
  static std::string named(const std::vector<std::string>& words) {
    const auto shown = std::min(words.size(), kWordsNamed);
    return fmt::format(
        "{}{}",
        fmt::join(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
        words.size() > shown ? ", ..." : "");
  }

  const Corpus& corpus_;
  std::vector<std::string> absent_;
  std::vector<std::string> doubtful_;
  std::set<std::string> talkers_;    ///< of the words that there are
  std::set<std::string> different_;  ///< words and their phones here and there
};

}  // namespace

void judge_repertoire(const Cast& cast,
                      const std::vector<Word>& words,
                      const std::vector<Word>& practice,
                      Findings& findings) {
  std::set<std::string_view> known;
  const auto judge = [&](const std::string& talker, const std::string& pointer, bool seen) {
    if (!is_corpus(talker)) return;
    const auto corpus = cast.corpora.find(corpus_name(talker));
    if (corpus == cast.corpora.end()) return;
    Repertoire repertoire{corpus->second};
    for (const auto* list : {&practice, &words}) {
      for (const auto& word : *list) {
        if (seen && word.seen) {
          repertoire.need(word.seen->spelling, word.seen->phones);
        } else {
          repertoire.need(word.spelling, word.phones);
        }
      }
    }
    repertoire.tell(pointer, findings);
    if (known.insert(corpus->first).second) repertoire.tell_of_talkers(pointer, findings);
  };
  for (std::size_t i = 0; i < cast.conditions.size(); ++i) {
    const auto& condition = cast.conditions[i];
    const auto& pointer = cast.pointers[i];
    if (condition.auditory_talker) {
      judge(*condition.auditory_talker, pointer + "/auditory/talker", false);
    }
    if (condition.visual_talker) judge(*condition.visual_talker, pointer + "/visual/talker", true);
    const bool timed_apart = !condition.auditory_talker && condition.visual_talker &&
                             !is_corpus(*condition.visual_talker);
    if (timed_apart) judge(condition.timing_talker, pointer + "/timing/talker", true);
  }
}

}  // namespace bimodal::protocols
