#include "protocols/reading/judge_repertoire.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/ranges.h>

#include "stimuli/base/counted.hpp"

namespace bimodal::protocols {

namespace {

constexpr std::size_t kWordsNamed = 5;  ///< in a message about many

/// The first few.
std::string named(const std::vector<std::string>& words) {
  const auto shown = std::min(words.size(), kWordsNamed);
  return fmt::format(
      "{}{}",
      fmt::join(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
      words.size() > shown ? ", ..." : "");
}

/// What is to be said of a corpus that has to say some words, each once.
class Repertoire {
 public:
  explicit Repertoire(const Corpus& corpus) : corpus_{corpus} {}

  /// `is_timing_ambiguous`: a face says ambiguous segments in time with the recording.
  void need(const std::string& word, const Pronunciation& phones, bool is_timing_ambiguous) {
    if (const auto* const item = find_item(corpus_, word)) {
      talkers_.insert(corpus_.recordings.at(item->recording).talker);
      const bool rests = std::ranges::any_of(
          item->phones, [](const TimedPhone& timed) { return timed.phone == Phone::Rest; });
      const auto said = pronunciation_of(*item);
      if (is_timing_ambiguous && said.size() != phones.size()) {
        unequal_.insert(fmt::format("{} ({}, in the list {})", word, spell(said), spell(phones)));
      }
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
    if (!unequal_.empty()) {
      findings.error(
          pointer,
          fmt::format("the corpus \"{}\" has more or fewer phones, so that it cannot time the "
                      "ambiguous segments of {}: {}",
                      corpus_.name,
                      counted(unequal_.size(), "word"),
                      named({unequal_.begin(), unequal_.end()})),
          "give these words a segment for each phone of the recording");
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
  const Corpus& corpus_;
  std::vector<std::string> absent_;
  std::vector<std::string> doubtful_;
  std::set<std::string> talkers_;    ///< of the words that there are
  std::set<std::string> unequal_;    ///< ambiguous words that the recordings cannot time
  std::set<std::string> different_;  ///< words and their phones here and there
};

/// Goes through conditions, and tells what is to be told of a corpus once.
class Judgement {
 public:
  Judgement(const Cast& cast,
            const std::vector<Word>& words,
            const std::vector<Word>& practice,
            Findings& findings)
      : cast_{cast}, lists_{&practice, &words}, findings_{findings} {}

  void judge(const Condition& condition, const std::string& pointer) {
    const bool has_face = condition.visual_talker && !is_corpus(*condition.visual_talker);
    const auto part = [&](bool heard, bool seen) {
      return Part{.heard = heard, .seen = seen, .times_face = has_face};
    };
    if (condition.auditory_talker) {
      judge_talker(*condition.auditory_talker, pointer + "/auditory/talker", part(true, has_face));
      judge_voice(*condition.auditory_talker, pointer + "/auditory/talker");
    } else if (has_face) {
      judge_talker(condition.timing_talker, pointer + "/timing/talker", part(false, true));
    }
    if (condition.visual_talker) {
      judge_talker(*condition.visual_talker, pointer + "/visual/talker", part(false, true));
    }
  }

 private:
  /// What a talker has to say.
  struct Part {
    bool heard;
    bool seen;        ///< what is seen, also where another word is heard
    bool times_face;  ///< the synthetic face moves in its time
  };

  void judge_talker(const std::string& talker, const std::string& pointer, Part part) {
    if (!is_corpus(talker)) return;
    const auto corpus = cast_.corpora.find(corpus_name(talker));
    if (corpus == cast_.corpora.end()) return;
    Repertoire repertoire{corpus->second};
    for (const auto* list : lists_) {
      for (const auto& word : *list) {
        const bool is_dubbed = word.seen.has_value();
        if (part.heard || (part.seen && !is_dubbed)) {
          const bool is_ambiguous = part.seen && !is_dubbed && !word.articulation.empty();
          repertoire.need(word.spelling, word.phones, part.times_face && is_ambiguous);
        }
        if (part.seen && is_dubbed) {
          const bool is_ambiguous = !word.seen->articulation.empty();
          repertoire.need(word.seen->spelling, word.seen->phones, part.times_face && is_ambiguous);
        }
      }
    }
    repertoire.tell(pointer, findings_);
    if (known_.insert(corpus->first).second) repertoire.tell_of_talkers(pointer, findings_);
  }

  /// A synthetic voice has no ambiguous sounds.
  void judge_voice(const std::string& talker, const std::string& pointer) {
    if (is_corpus(talker)) return;
    std::vector<std::string> nearer;
    for (const auto* list : lists_) {
      for (const auto& word : *list) {
        const bool is_between = std::ranges::any_of(word.articulation, [](const Segment& segment) {
          return segment.is_ambiguous() && segment.step != 0 && segment.step != segment.steps;
        });
        if (is_between && !word.seen)
          nearer.push_back(fmt::format("{} as {}", word.spelling, spell(word.phones)));
      }
    }
    if (nearer.empty()) return;
    findings_.warning(
        pointer,
        fmt::format("the voice has no ambiguous sounds; it says the nearer ones of {}: {}",
                    counted(nearer.size(), "word"),
                    named(nearer)),
        "let one sound be heard and the ambiguous one be seen (\"word\": \"ba\", \"seen\": ...), "
        "or "
        "make a corpus of your ambiguous sounds");
  }

  const Cast& cast_;
  std::array<const std::vector<Word>*, 2> lists_;
  Findings& findings_;
  std::set<std::string_view> known_;
};

}  // namespace

void judge_repertoire(const Cast& cast,
                      const std::vector<Word>& words,
                      const std::vector<Word>& practice,
                      Findings& findings) {
  Judgement judgement{cast, words, practice, findings};
  for (std::size_t i = 0; i < cast.conditions.size(); ++i) {
    judgement.judge(cast.conditions[i], cast.pointers[i]);
  }
}

}  // namespace bimodal::protocols
