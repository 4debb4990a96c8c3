#include "stimuli/words/letter_to_sound.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "stimuli/base/asset.hpp"
#include "stimuli/words/letter_context.hpp"
#include "stimuli/words/plain_text.hpp"

namespace bimodal {

namespace {

constexpr std::size_t kNowhere = std::string_view::npos;

bool is_of_word(char letter) {
  return (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9');
}

/// A text as the rules expect it, and where in the original each of its characters stands.
class PreparedText {
 public:
  explicit PreparedText(std::string_view original) {
    put_blank(kNowhere);
    for (std::size_t at = 0; at < original.size(); ++at) {
      const char written = original[at];
      const char letter =
          written >= 'a' && written <= 'z' ? static_cast<char>(written - 'a' + 'A') : written;
      const bool is_mark = kRulePunctuation.find(letter) != std::string_view::npos;
      if (!is_mark && !is_of_word(letter)) {
        put_blank(at);
        continue;
      }
      if (is_mark == is_of_word(letters_.back())) put_blank(kNowhere);
      put(letter, at);
    }
    put_blank(kNowhere);
  }

  [[nodiscard]] std::string_view letters() const { return letters_; }

  [[nodiscard]] std::size_t origin(std::size_t at) const { return origins_[at]; }

  /// Whether the writer parted words here.
  [[nodiscard]] bool is_written_blank(std::size_t at) const {
    return letters_[at] == ' ' && origins_[at] != kNowhere;
  }

 private:
  void put(char letter, std::size_t origin) {
    letters_ += letter;
    origins_.push_back(origin);
  }

  void put_blank(std::size_t origin) {
    if (letters_.empty() || letters_.back() != ' ') {
      put(' ', origin);
    } else if (origin != kNowhere) {
      origins_.back() = origin;
    }
  }

  std::string letters_;
  std::vector<std::size_t> origins_;
};

/// Gathers what the rules say into words.
class WordGatherer {
 public:
  WordGatherer(std::string_view original, const PreparedText& text)
      : original_{original}, text_{text} {}

  void read(std::size_t begin, const LetterRule& rule) {
    phones_.insert(phones_.end(), rule.phones.begin(), rule.phones.end());
    bool parted = rule.ends.has_value();
    auto pause = rule.ends.value_or(Pause::None);
    for (std::size_t at = begin; at < begin + rule.letters.size(); ++at) {
      if (text_.is_written_blank(at)) parted = true;
      const auto origin = text_.origin(at);
      if (origin != kNowhere && parts_no_words(original_, origin)) pause = Pause::None;
      if (!is_of_word(text_.letters()[at])) continue;
      if (begin_ == kNowhere) begin_ = text_.origin(at);
      end_ = text_.origin(at) + 1;
    }
    if (parted) finish(pause);
  }

  std::vector<PronouncedWord> take() {
    finish(Pause::None);
    return std::move(words_);
  }

 private:
  /// A pause that follows no word strengthens the one before; at the start of the text it is none.
  void finish(Pause pause) {
    if (begin_ != kNowhere) {
      words_.push_back({.written = std::string{original_.substr(begin_, end_ - begin_)},
                        .phones = std::exchange(phones_, {}),
                        .after = Pause::None,
                        .source = PhoneSource::Rules});
      begin_ = kNowhere;
    }
    if (!words_.empty()) words_.back().after = std::max(words_.back().after, pause);
  }

  std::string_view original_;
  const PreparedText& text_;
  std::vector<PronouncedWord> words_;
  Pronunciation phones_;          ///< of the word that is being read
  std::size_t begin_ = kNowhere;  ///< its first letter or digit in the original
  std::size_t end_ = kNowhere;
};

}  // namespace

LetterToSound::LetterToSound(std::vector<LetterRule> rules) : rules_{std::move(rules)} {
  for (std::size_t i = 0; i < rules_.size(); ++i) {
    const auto first = static_cast<unsigned char>(rules_[i].letters.front());
    by_first_letter_.at(first).push_back(i);
  }
}

LetterToSound LetterToSound::shipped() {
  return LetterToSound{read_letter_rules(asset("stimuli/assets/words/nrl-rules.tsv"))};
}

const LetterRule* LetterToSound::rule_at(std::string_view text, std::size_t at) const {
  for (const auto i : by_first_letter_.at(static_cast<unsigned char>(text[at]))) {
    const auto& rule = rules_[i];
    if (text.substr(at).starts_with(rule.letters) && stands_before(rule.left, text, at) &&
        stands_after(rule.right, text, at + rule.letters.size())) {
      return &rule;
    }
  }
  return nullptr;
}

std::vector<PronouncedWord> LetterToSound::words(std::string_view text) const {
  const PreparedText prepared{text};
  WordGatherer gatherer{text, prepared};
  for (std::size_t at = 1; at < prepared.letters().size();) {  // the first blank is no word's end
    const auto* const rule = rule_at(prepared.letters(), at);
    if (rule != nullptr) gatherer.read(at, *rule);
    at += rule != nullptr ? rule->letters.size() : 1;
  }
  return gatherer.take();
}

}  // namespace bimodal
