#include "stimuli/corpus/check_corpus.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "stimuli/base/counted.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/milliseconds.hpp"
#include "stimuli/corpus/cut_items.hpp"
#include "stimuli/video/frame_reader.hpp"
#include "stimuli/video/sound_track.hpp"

namespace bimodal {

namespace {

constexpr double kLevelRange = 12.0;    ///< dB around the median
constexpr double kQuietMargin = -20.0;  ///< dB re the speech
constexpr double kUneven = 0.25;        ///< of the median frame
constexpr Duration kApart = std::chrono::milliseconds{100};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

SpeechInterval speech_of(const CorpusItem& item) {
  return {item.phones.front().start, item.phones.back().end()};
}

ItemFrames frames_of(const std::filesystem::path& file, const CorpusItem& item) {
  FrameReader reader{file, {.span = {item.start, item.end}}};
  ItemFrames found;
  std::vector<double> lengths;
  std::vector<std::uint8_t> before;
  while (auto frame = reader.next()) {
    ++found.count;
    lengths.push_back(milliseconds(frame->end - frame->start));
    if (frame->image.pixels == before) ++found.doubled;
    before = std::move(frame->image.pixels);
  }
  if (lengths.empty()) return found;
  const double usual = median(lengths);
  found.uneven = static_cast<std::size_t>(std::ranges::count_if(
      lengths, [&](double length) { return std::abs(length - usual) > kUneven * usual; }));
  return found;
}

class Checker {
 public:
  Checker(const Corpus& corpus, const Progress& progress) : corpus_{corpus}, progress_{progress} {
    check_.recordings.resize(corpus.recordings.size());
    check_.items.resize(corpus.items.size());
  }

  CorpusCheck check(std::span<const Word> list) {
    for (std::size_t i = 0; i < corpus_.recordings.size(); ++i) check_recording(i);
    judge_levels();
    count_words(list);
    return std::move(check_);
  }

 private:
  void check_recording(std::size_t index) {
    auto& found = check_.recordings[index];
    std::vector<std::size_t> items;
    for (std::size_t i = 0; i < corpus_.items.size(); ++i) {
      if (corpus_.items[i].recording == index) items.push_back(i);
    }
    const auto file = media_file(corpus_, index);
    std::optional<Clip> sound;
    try {
      if (sha256_of_file(file) != corpus_.recordings[index].sha256) {
        found.errors.emplace_back(
            "its SHA-256 is not the manifest's: it has been changed; put the original back, or "
            "build "
            "the corpus again");
      }
      found.media = examine_media(file);
      judge_tracks(found);
      if (found.media->sound) sound = read_sound_track(file);
    } catch (const Error& error) {
      found.errors.push_back(describe(error));
    }
    neighboured_ = 0;
    for (const auto item : items) {
      check_item(item, file, found, sound);
      if (progress_) {
        progress_("checking the items",
                  static_cast<double>(++done_) / static_cast<double>(corpus_.items.size()));
      }
    }
    if (neighboured_ == 0) return;
    found.findings.push_back(
        fmt::format("{} of its {} a neighbouring word within {:.0f} ms, which is made silent",
                    neighboured_,
                    items.size() == 1 ? "1 item has" : fmt::format("{} items have", items.size()),
                    milliseconds(kLeastMargin)));
  }

  static void judge_tracks(RecordingCheck& found) {
    const auto& media = *found.media;
    if (!media.sound) found.errors.emplace_back("it has no sound");
    if (media.picture && media.picture->variable_rate) {
      found.findings.emplace_back(
          "its frames do not come at equal distances (variable frame rate); they are shown when "
          "the "
          "file says");
    }
    if (!media.sound || !media.picture) return;
    found.sound_begins_later = media.sound->start - media.picture->start;
    found.sound_ends_later =
        *found.sound_begins_later + media.sound->length - media.picture->length;
    for (const auto& [later, what] : {std::pair{*found.sound_begins_later, "begins"},
                                      std::pair{*found.sound_ends_later, "ends"}}) {
      if (std::chrono::abs(later) <= kApart) continue;
      found.findings.push_back(fmt::format("its sound {} {:.0f} ms {} than its picture",
                                           what,
                                           std::abs(milliseconds(later)),
                                           later > Duration{} ? "later" : "earlier"));
    }
  }

  void check_item(std::size_t index,
                  const std::filesystem::path& file,
                  const RecordingCheck& recording,
                  const std::optional<Clip>& sound) {
    const auto& item = corpus_.items[index];
    auto& found = check_.items[index];
    const auto speech = speech_of(item);
    found.before = speech.start - item.start;
    found.after = item.end - speech.end;
    if (!item.doubt.empty()) found.findings.push_back("doubtful: " + item.doubt);
    if (!sound) {
      found.errors.emplace_back("its recording's sound cannot be read");
    } else {
      check_sound(item, *sound, found);
    }
    if (!recording.media || !recording.media->picture) return;
    try {
      found.frames = frames_of(file, item);
      judge_frames(found);
    } catch (const Error& error) {
      found.errors.push_back(describe(error));
    }
  }

  void check_sound(const CorpusItem& item, const Clip& sound, ItemCheck& found) {
    try {
      found.sound = measure_item(sound, {item.start, item.end}, speech_of(item), fourier_);
    } catch (const Error&) {
      found.errors.push_back(fmt::format("it ends at {:.2f} s, its recording's sound at {:.2f} s",
                                         milliseconds(item.end) / 1000.0,
                                         milliseconds(sound.duration()) / 1000.0));
      return;
    }
    if (!std::isfinite(found.sound->speech.count())) found.errors.emplace_back("it is silent");
    if (found.sound->clipped > 0) {
      found.findings.push_back(
          fmt::format("cut off at full scale in {}", counted(found.sound->clipped, "place")));
    }
    const auto clear = item.clear.value_or(SpeechInterval{item.start, item.end});
    const auto speech = speech_of(item);
    const bool before = judge_margin(
        found, found.before, speech.start - clear.start, found.sound->before, "before");
    const bool after =
        judge_margin(found, found.after, clear.end - speech.end, found.sound->after, "after");
    if (before || after) ++neighboured_;
  }

  /// Returns whether a neighbour is within the least margin.
  static bool judge_margin(
      ItemCheck& found, Duration margin, Duration clear, Decibels level, std::string_view where) {
    const double relative = level.count() - found.sound->speech.count();
    if (margin < kLeastMargin) {
      found.findings.push_back(
          fmt::format("only {:.0f} ms of sound {} it", milliseconds(margin), where));
    } else if (clear < kLeastMargin) {
      return true;
    } else if (relative > kQuietMargin) {
      found.findings.push_back(
          fmt::format("the margin {} it is not silent ({:.0f} dB)", where, relative));
    }
    return false;
  }

  static void judge_frames(ItemCheck& found) {
    const auto& frames = *found.frames;
    if (frames.uneven > 0) {
      found.findings.push_back(
          fmt::format("{} longer or shorter than the others (dropped frames?)",
                      counted(frames.uneven, "frame") + (frames.uneven == 1 ? " is" : " are")));
    }
    if (frames.doubled > 0) {
      found.findings.push_back(
          fmt::format("{} the same as the one before (doubled, or nothing moves)",
                      counted(frames.doubled, "frame") + (frames.doubled == 1 ? " is" : " are")));
    }
  }

  void judge_levels() {
    std::vector<double> levels;
    for (const auto& item : check_.items) {
      if (item.sound && std::isfinite(item.sound->speech.count())) {
        levels.push_back(item.sound->speech.count());
      }
    }
    if (levels.empty()) return;
    check_.median_level = Decibels{median(levels)};
    if (levels.size() > 1) check_.level_sd_db = standard_deviation(levels);
    for (auto& item : check_.items) {
      if (!item.sound) continue;
      const double difference = item.sound->speech.count() - check_.median_level->count();
      if (std::abs(difference) <= kLevelRange || !std::isfinite(difference)) continue;
      item.findings.push_back(fmt::format("{:.0f} dB {} than the median item",
                                          std::abs(difference),
                                          difference > 0 ? "louder" : "weaker"));
    }
  }

  static double standard_deviation(const std::vector<double>& values) {
    double mean = 0.0;
    for (const double value : values) mean += value / static_cast<double>(values.size());
    double squares = 0.0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
  }

  void count_words(std::span<const Word> list) {
    std::map<std::string_view, std::size_t> usable;
    for (const auto& item : corpus_.items) {
      if (item.doubt.empty()) ++usable[item.word];
    }
    for (const auto& word : list) {
      if (!usable.contains(word.spelling)) check_.missing.push_back(word.spelling);
    }
    for (const auto& [word, count] : usable) {
      if (count > 1) check_.doubled.emplace_back(word);
    }
  }

  const Corpus& corpus_;
  const Progress& progress_;
  FourierTransform fourier_;
  CorpusCheck check_;
  std::size_t done_ = 0;
  std::size_t neighboured_ = 0;  ///< items of the recording with a neighbour in the least margin
};

template <typename Count>
std::size_t sum(const CorpusCheck& check, const Count& count) {
  std::size_t all = 0;
  for (const auto& recording : check.recordings) all += count(recording).size();
  for (const auto& item : check.items) all += count(item).size();
  return all;
}

}  // namespace

std::size_t CorpusCheck::findings() const {
  return missing.size() + sum(
                              *this, [](const auto& part) -> const auto& { return part.findings; });
}

std::size_t CorpusCheck::errors() const {
  return sum(
      *this, [](const auto& part) -> const auto& { return part.errors; });
}

CorpusCheck check_corpus(const Corpus& corpus,
                         std::span<const Word> list,
                         const Progress& progress) {
  return Checker{corpus, progress}.check(list);
}

}  // namespace bimodal
