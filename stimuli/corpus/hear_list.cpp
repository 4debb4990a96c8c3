#include "stimuli/corpus/hear_list.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "stimuli/alignment/aligner.hpp"
#include "stimuli/alignment/word_listener.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/corpus/match_list.hpp"
#include "stimuli/corpus/side_by_side.hpp"
#include "stimuli/corpus/speech_chunks.hpp"
#include "stimuli/corpus/word_doubts.hpp"

namespace bimodal {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMostPairs = 20'000'000;
/// How far from the diagonal words are compared. Also as many as are needed for the best of them to
/// be a measure of how well anything fits.
constexpr std::int64_t kReach = 40;
/// Around a chunk: what is too weak to be part of it belongs to the word all the same.
constexpr Duration kAround = 150ms;
/// A chunk shorter than this holds no two words, nor one that is not much longer than the others.
constexpr Duration kShortestPair = 600ms;
constexpr double kPairToMedian = 1.25;
constexpr Duration kLongestWord = 3s;
/// A word that fits this much worse than another one is doubtful: of words really said 5 % do.
constexpr float kMoreLikeAnother = -1.5F;
/// Percent of a chunk that the word's phones must cover.
constexpr std::int64_t kLeastCoverage = 65;
/// What is read out of order must fit nearly as well as the best.
constexpr float kOutOfOrder = -0.7F;

/// A chunk with its surroundings.
struct Stretch {
  SpeechInterval chunk;
  Duration start{};
  Clip sound;
};

Stretch stretch_of(const Clip& sound, std::span<const SpeechInterval> chunks, std::size_t index) {
  const auto& chunk = chunks[index];
  const auto before = index > 0 ? chunks[index - 1].end : Duration{};
  const auto after = index + 1 < chunks.size() ? chunks[index + 1].start : sound.duration();
  const auto start = std::max((before + chunk.start) / 2, chunk.start - kAround);
  const auto end = std::min({(after + chunk.end) / 2 + 1ns, chunk.end + kAround, sound.duration()});
  const auto samples = cut(sound, {start, end});
  return {chunk, start, {sound.rate, {samples.begin(), samples.end()}}};
}

SpokenWord spoken(const Word& word) {
  return {word.spelling, {word.phones}};
}

class ListSearch {
 public:
  ListSearch(const Clip& sound, std::span<const Word> list, const Progress& progress)
      : sound_{sound}, list_{list}, progress_{progress}, chunks_{find_speech(sound)}, fits_{0, 0} {
    refuse_impossible();
    fits_ = ChunkWordFits{chunks_.size(), list.size()};
    best_.resize(chunks_.size());
    std::ranges::transform(list, std::back_inserter(words_), spoken);
  }

  SaidWords search() {
    compare_all();
    auto matches = match_list(fits_);
    const auto late = match_left_over(matches);
    matches.insert(matches.end(), late.begin(), late.end());
    std::ranges::sort(matches, {}, &Match::chunk);
    return align_all(matches, late);
  }

 private:
  /// The word that a chunk fits best, of those that it was compared with.
  struct Best {
    std::optional<std::size_t> word;
    double fit = -HUGE_VAL;  ///< of the chunk, be it one word or two
  };

  void refuse_impossible() const {
    if (list_.empty())
      throw Error{"finding words: the list is empty; give the words that were read"};
    if (chunks_.empty()) {
      throw Error{fmt::format(
          "finding the words of the list: there is no speech in the recording of {:.1f} s; check "
          "that its sound is the talker's",
          std::chrono::duration<double>{sound_.duration()}.count())};
    }
    if (chunks_.size() > kMostPairs / list_.size()) {
      throw Error{fmt::format(
          "finding the words of the list: {} chunks of speech and {} words are too many; cut the "
          "recording into parts and give each its part of the list",
          chunks_.size(),
          list_.size())};
    }
  }

  void tell(std::string_view deed, std::size_t count) {
    const std::scoped_lock lock{mutex_};
    ++done_;
    if (progress_) progress_(deed, static_cast<double>(done_) / static_cast<double>(count));
  }

  /// The words that may be due at a chunk.
  [[nodiscard]] std::pair<std::size_t, std::size_t> due(std::size_t chunk) const {
    const auto words = static_cast<std::int64_t>(words_.size());
    const auto spare = words - static_cast<std::int64_t>(chunks_.size());
    const auto at = static_cast<std::int64_t>(chunk);
    const auto first =
        std::clamp<std::int64_t>(at + std::min<std::int64_t>(0, spare) - kReach, 0, words);
    const auto end =
        std::clamp<std::int64_t>(at + std::max<std::int64_t>(0, spare) + kReach + 1, 0, words);
    return {static_cast<std::size_t>(first), static_cast<std::size_t>(end)};
  }

  [[nodiscard]] Duration median_length() const {
    std::vector<Duration> lengths;
    for (const auto& chunk : chunks_) lengths.push_back(chunk.end - chunk.start);
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::ranges::nth_element(lengths, middle);
    return *middle;
  }

  void compare_all() {
    const auto median = std::chrono::duration<double>{median_length()};
    const auto pair_from =
        std::max(std::chrono::duration<double>{kShortestPair}, kPairToMedian * median);
    side_by_side(chunks_.size(), [&] {
      return [this, pair_from, ear = WordListener{}](std::size_t chunk) mutable {
        const auto length = chunks_[chunk].end - chunks_[chunk].start;
        if (length <= kLongestWord) {
          const auto [first, end] = due(chunk);
          compare(ear, chunk, first, end, length >= pair_from);
        }
        tell("comparing the sound with the words", chunks_.size());
      };
    });
    done_ = 0;
  }

  void compare(
      WordListener& ear, std::size_t chunk, std::size_t first, std::size_t end, bool pairs) {
    const auto stretch = stretch_of(sound_, chunks_, chunk);
    const auto heard = ear.listen(stretch.sound, stretch.chunk.end - stretch.chunk.start);
    auto& best = best_[chunk];
    for (std::size_t word = first; word < end; ++word) {
      if (const auto fit = heard.fit(words_[word])) {
        fits_.one(chunk, word) = static_cast<float>(*fit);
        if (*fit > best.fit) best = {word, *fit};
      }
      if (!pairs || word + 1 >= words_.size()) continue;
      if (const auto fit = heard.fit(std::span{words_}.subspan(word, 2))) {
        fits_.two(chunk, word) = static_cast<float>(*fit);
        if (*fit > best.fit) best = {std::nullopt, *fit};
      }
    }
    // From here on relative to what fits best.
    for (std::size_t word = first; word < end; ++word) {
      fits_.one(chunk, word) -= static_cast<float>(best.fit);
      fits_.two(chunk, word) -= static_cast<float>(best.fit);
    }
  }

  /// Chunks that are nothing in their place, but a missing word.
  std::vector<Match> match_left_over(const std::vector<Match>& matches) {
    std::set<std::size_t> missing;
    for (std::size_t word = 0; word < words_.size(); ++word) missing.insert(word);
    std::set<std::size_t> left;
    for (std::size_t chunk = 0; chunk < chunks_.size(); ++chunk) {
      if (chunks_[chunk].end - chunks_[chunk].start <= kLongestWord) left.insert(chunk);
    }
    for (const auto& match : matches) {
      left.erase(match.chunk);
      missing.erase(match.word);
      if (match.with_next) missing.erase(match.word + 1);
    }
    std::vector<Match> found;
    if (missing.empty() || left.empty()) return found;
    WordListener ear;
    for (const auto chunk : left) {
      for (std::size_t word = 0; word < words_.size(); ++word) {
        fits_.one(chunk, word) = ChunkWordFits::kNotCompared;
      }
      best_[chunk] = {};
      compare(ear, chunk, 0, words_.size(), false);
      const auto word = *std::ranges::max_element(
          missing, {}, [&](std::size_t of) { return fits_.one(chunk, of); });
      if (fits_.one(chunk, word) < kOutOfOrder) continue;
      found.push_back({chunk, word, false});
      missing.erase(word);
      if (missing.empty()) break;
    }
    return found;
  }

  SaidWords align_all(const std::vector<Match>& matches, const std::vector<Match>& late) {
    std::vector<std::vector<SaidWord>> aligned(matches.size());
    side_by_side(matches.size(), [&] {
      return [&, aligner = Aligner{}](std::size_t index) mutable {
        aligned[index] = align(aligner, matches[index]);
        if (std::ranges::find(late, matches[index]) != late.end()) {
          aligned[index].front().doubts.emplace_back(
              "stands out of the list's order; only its sound tells that it is this word");
        }
        tell("aligning the words", matches.size());
      };
    });
    doubt_alleged_takes(matches, late, aligned);
    SaidWords said;
    std::vector<bool> is_word(chunks_.size());
    for (std::size_t index = 0; index < matches.size(); ++index) {
      is_word[matches[index].chunk] = true;
      std::ranges::move(aligned[index], std::back_inserter(said.words));
    }
    for (std::size_t chunk = 0; chunk < chunks_.size(); ++chunk) {
      if (!is_word[chunk]) said.others.push_back(chunks_[chunk]);
    }
    return said;
  }

  /// What sounds like a word said again may be the word after it, if that is missing: neighbours in
  /// an alphabetical list sound alike.
  void doubt_alleged_takes(const std::vector<Match>& matches,
                           const std::vector<Match>& late,
                           std::vector<std::vector<SaidWord>>& aligned) const {
    std::vector<bool> found(words_.size() + 1);
    found.back() = true;
    for (const auto& match : matches) {
      if (std::ranges::find(late, match) != late.end()) continue;
      found[match.word] = true;
      if (match.with_next) found[match.word + 1] = true;
    }
    for (std::size_t i = 1; i < matches.size(); ++i) {
      const auto word = matches[i].word;
      if (matches[i - 1].word != word || found[word + 1]) continue;
      aligned[i].front().doubts.push_back(
          fmt::format("may be \"{}\", which is not in its place", words_[word + 1].spelling));
    }
  }

  std::vector<SaidWord> align(Aligner& aligner, const Match& match) {
    const auto stretch = stretch_of(sound_, chunks_, match.chunk);
    const auto words = std::span{words_}.subspan(match.word, match.with_next ? 2 : 1);
    const auto alignment = aligner.align(stretch.sound, words);
    auto said = said_words(alignment, stretch.start);
    const auto& best = best_[match.chunk];
    const auto fit =
        match.with_next ? fits_.two(match.chunk, match.word) : fits_.one(match.chunk, match.word);
    if (fit < kMoreLikeAnother && best.word) {
      for (auto& word : said) {
        word.doubts.push_back(fmt::format("sounds more like \"{}\"", words_[*best.word].spelling));
      }
    }
    judge_coverage(said, stretch.chunk);
    if (match.with_next) {
      for (auto& word : said) word.doubts.emplace_back("read without a pause to its neighbour");
    }
    return said;
  }

  /// Where much of the chunk is left over, something else is said too, or the alignment is wrong.
  static void judge_coverage(std::vector<SaidWord>& said, const SpeechInterval& chunk) {
    const auto covered =
        std::min(said.back().end(), chunk.end) - std::max(said.front().start(), chunk.start);
    const auto percent = 100 * covered / (chunk.end - chunk.start);
    if (percent >= kLeastCoverage) return;
    said.front().doubts.push_back(fmt::format("its phones cover only {} % of the sound there",
                                              std::max<std::int64_t>(0, percent)));
  }

  const Clip& sound_;
  std::span<const Word> list_;
  const Progress& progress_;
  std::vector<SpeechInterval> chunks_;
  std::vector<SpokenWord> words_;
  ChunkWordFits fits_;
  std::vector<Best> best_;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

}  // namespace

SaidWords hear_list(const Clip& sound, std::span<const Word> list, const Progress& progress) {
  return ListSearch{sound, list, progress}.search();
}

}  // namespace bimodal
