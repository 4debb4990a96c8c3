#include "stimuli/corpus/build_corpus.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/corpus/corpus_folder.hpp"
#include "stimuli/corpus/cut_items.hpp"
#include "stimuli/corpus/hear_text.hpp"
#include "stimuli/corpus/item_sound.hpp"
#include "stimuli/corpus/labelled_words.hpp"
#include "stimuli/corpus/spoken_text.hpp"
#include "stimuli/labels/label_file.hpp"
#include "stimuli/video/media_file.hpp"
#include "stimuli/video/sound_track.hpp"

namespace bimodal {

namespace {

namespace fs = std::filesystem;

constexpr double kLevelRange = 12.0;

double seconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

/// One recording's part of the corpus, before items have names of their own.
struct BuiltRecording {
  Recording recording;
  std::vector<CorpusItem> items;
  std::vector<Decibels> levels;  ///< of the items' speech
};

class Builder {
 public:
  Builder(const BuildRequest& request, const Progress& progress)
      : request_{request},
        progress_{progress},
        pronouncer_{request.list.words},
        labels_{request.folder} {}

  BuildReport build() {
    read_earlier();
    const auto files = recordings();
    refuse_equal_names(files);
    for (const auto& file : files) {
      try {
        built_.push_back(build_recording(file));
      } catch (const Error& error) {
        find(Severity::Error, file, describe(error), "");
      }
    }
    assemble();
    if (!report_.corpus.recordings.empty()) write_corpus(report_.corpus);
    return std::move(report_);
  }

 private:
  void find(Severity severity, const fs::path& file, std::string finding, std::string remedy) {
    report_.findings.push_back(
        {severity, file.string(), 0, "", std::move(finding), std::move(remedy)});
  }

  void read_earlier() {
    std::error_code ignored;
    if (!fs::exists(request_.folder / kManifestName, ignored)) return;
    std::vector<Diagnostic> diagnostics;
    earlier_ = read_corpus(request_.folder, diagnostics);
    if (has_errors(diagnostics)) {
      throw Error{
          fmt::format("cannot build on the corpus that is there: {}; mend it, or build in "
                      "another folder",
                      describe(diagnostics.front()))};
    }
  }

  [[nodiscard]] std::vector<fs::path> recordings() const {
    if (!request_.recordings.empty()) return request_.recordings;
    std::vector<fs::path> files;
    for (std::size_t i = 0; i < earlier_.recordings.size(); ++i) {
      files.push_back(media_file(earlier_, i));
    }
    if (files.empty()) {
      throw Error{
          fmt::format("cannot build the corpus '{}': no recordings were named, and it has "
                      "none yet; name the files to be taken",
                      request_.folder.string())};
    }
    return files;
  }

  static void refuse_equal_names(const std::vector<fs::path>& files) {
    std::map<std::string, fs::path> seen;
    for (const auto& file : files) {
      const auto [first, is_new] = seen.emplace(file.stem().string(), file);
      if (is_new) continue;
      throw Error{
          fmt::format("two recordings are called '{}': '{}' and '{}'; rename one, since "
                      "labels and texts go by that name",
                      file.stem().string(),
                      first->second.string(),
                      file.string())};
    }
  }

  [[nodiscard]] const Recording* earlier_recording(const std::string& file) const {
    const auto found = std::ranges::find(earlier_.recordings, file, &Recording::file);
    return found == earlier_.recordings.end() ? nullptr : &*found;
  }

  BuiltRecording build_recording(const fs::path& file) {
    if (progress_) progress_(fmt::format("reading {}", file.filename().string()), 0.0);
    const auto media = examine_media(file);
    if (!media.sound) {
      throw Error{
          fmt::format("cannot find words in the recording '{}': it has no sound; record the "
                      "talker's voice with the picture, even if only the picture is shown",
                      file.string())};
    }
    auto sound = read_sound_track(file);
    const auto said = words_in(file, sound);
    BuiltRecording built;
    built.items =
        cut_items(said, sound, [&](std::string_view word) { return pronouncer_.is_listed(word); });
    FourierTransform fourier;
    for (const auto& item : built.items) {
      const SpeechInterval speech{item.phones.front().start,
                                  std::min(item.phones.back().end(), sound.duration())};
      built.levels.push_back(measure_item(sound, {item.start, item.end}, speech, fourier).speech);
    }
    tell_of_others(file, said);
    built.recording = keep_media(file, media, sound);
    keep_labels(file.stem().string(), said, sound.duration());
    return built;
  }

  SaidWords words_in(const fs::path& file, const Clip& sound) {
    const auto name = file.stem().string();
    if (labels_.edited(name)) return labelled(labels_.file_of(name), sound);
    for (const auto* const ending : {".TextGrid", ".lab", ".align"}) {
      auto beside = file;
      beside.replace_extension(ending);
      std::error_code ignored;
      if (fs::exists(beside, ignored)) return labelled(beside, sound);
    }
    if (const auto text = text_of(file)) {
      std::vector<SpokenWord> words;
      for (const auto& word : *text) words.push_back(pronouncer_.pronounce(word));
      keep_text(name, *text);
      return hear_text(sound, words);
    }
    by_list_ = true;
    return hear_list(sound, request_.list.words, progress_);
  }

  SaidWords labelled(const fs::path& file, const Clip& sound) {
    try {
      return labelled_words(read_labels(file), sound, request_.list.words, pronouncer_);
    } catch (const Error&) {
      std::throw_with_nested(Error{fmt::format("using the labels '{}'", file.string())});
    }
  }

  [[nodiscard]] std::optional<std::vector<std::string>> text_of(const fs::path& file) const {
    const auto name = file.stem().string();
    if (const auto given = request_.texts.find(name); given != request_.texts.end()) {
      return given->second;
    }
    auto beside = file;
    beside.replace_extension(".txt");
    for (const auto& text : {beside, kept_text(name)}) {
      std::error_code ignored;
      if (fs::exists(text, ignored)) return read_text(text);
    }
    return std::nullopt;
  }

  [[nodiscard]] fs::path kept_text(const std::string& name) const {
    return request_.folder / "labels" / (name + ".txt");
  }

  void keep_text(const std::string& name, const std::vector<std::string>& words) const {
    write_file(kept_text(name), fmt::format("{}\n", fmt::join(words, " ")));
  }

  void tell_of_others(const fs::path& file, const SaidWords& said) {
    constexpr std::size_t kShown = 12;
    std::vector<std::string> stretches;
    for (const auto& other : said.others) {
      stretches.push_back(fmt::format("{:.2f}-{:.2f} s", seconds(other.start), seconds(other.end)));
    }
    const auto count = stretches.size();
    if (count > kShown) stretches.resize(kShown);
    if (count > 0) {
      find(Severity::Warning,
           file,
           fmt::format("{} none of the words: {}{}",
                       count == 1 ? "1 stretch of sound is"
                                  : fmt::format("{} stretches of sound are", count),
                       fmt::join(stretches, ", "),
                       count > kShown ? " ..." : ""),
           "listen to them; if one is a word, label it in Praat and build again");
    }
    std::set<std::string> ignored;
    for (const auto& word : said.words) {
      if (!pronouncer_.is_listed(word.word)) ignored.insert(word.word);
    }
    if (ignored.empty()) return;
    report_.notes.push_back(fmt::format(
        "{}: not in the list, so not taken: {}", file.string(), fmt::join(ignored, ", ")));
  }

  Recording keep_media(const fs::path& file, const Media& media, Clip& sound) const {
    Recording recording;
    recording.file = take_media(file, request_.folder);
    const auto kept = request_.folder / recording.file;
    recording.sha256 = sha256_of_file(kept);
    const auto* const before = earlier_recording(recording.file);
    const auto choose = [&](const std::optional<std::string>& given,
                            std::string Recording::*field) {
      return given ? *given : (before != nullptr ? before->*field : std::string{});
    };
    recording.talker = choose(request_.talker, &Recording::talker);
    if (recording.talker.empty()) recording.talker = file.stem().string();
    recording.licence = choose(request_.licence, &Recording::licence);
    recording.eye_distance_px = request_.eye_distance_px;
    if (!recording.eye_distance_px && before != nullptr) {
      recording.eye_distance_px = before->eye_distance_px;
    }
    if (media.picture) write_sound(file.stem().string(), sound);
    return recording;
  }

  /// Cuts off in place what lossy decoding has pushed beyond full scale: Praat reads no floats, and
  /// an hour of sound is not copied for that.
  void write_sound(const std::string& name, Clip& sound) const {
    const auto folder = request_.folder / "sound";
    std::error_code failure;
    fs::create_directories(folder, failure);
    for (auto& sample : sound.samples) sample = std::clamp(sample, -1.0F, 1.0F);
    write_wav(folder / (name + ".wav"), sound, SampleFormat::Pcm24);
  }

  void keep_labels(const std::string& name, const SaidWords& said, Duration length) {
    if (!labels_.edited(name)) labels_.write(name, labels_of(said, length));
  }

  void assemble() {
    auto& corpus = report_.corpus;
    corpus.folder = request_.folder;
    const auto folder_name = fs::absolute(request_.folder / ".").parent_path().filename().string();
    corpus.name = request_.name.value_or(earlier_.name.empty() ? folder_name : earlier_.name);
    corpus.description = request_.description.value_or(earlier_.description);
    keep_earlier(corpus);
    doubt_levels();
    for (auto& [recording, items, levels] : built_) {
      for (auto& item : items) {
        item.recording = corpus.recordings.size();
        corpus.items.push_back(std::move(item));
      }
      corpus.recordings.push_back(std::move(recording));
    }
    name_items(corpus);
    keep_verdicts(corpus);
    tell_of_missing(corpus);
  }

  /// Recordings that are not built again, with their items.
  void keep_earlier(Corpus& corpus) const {
    for (std::size_t i = 0; i < earlier_.recordings.size(); ++i) {
      const auto& file = earlier_.recordings[i].file;
      const bool is_new = std::ranges::any_of(
          built_, [&](const auto& built) { return built.recording.file == file; });
      if (is_new) continue;
      for (auto item : earlier_.items) {
        if (item.recording != i) continue;
        item.recording = corpus.recordings.size();
        corpus.items.push_back(std::move(item));
      }
      corpus.recordings.push_back(earlier_.recordings[i]);
    }
  }

  void doubt_levels() {
    std::map<std::string, std::vector<double>> of_talker;
    for (const auto& built : built_) {
      for (const auto level : built.levels) {
        if (std::isfinite(level.count()))
          of_talker[built.recording.talker].push_back(level.count());
      }
    }
    for (auto& [talker, levels] : of_talker) {
      std::ranges::nth_element(levels,
                               levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 2));
    }
    for (auto& built : built_) {
      for (std::size_t i = 0; i < built.items.size(); ++i) {
        const auto& levels = of_talker[built.recording.talker];
        if (levels.empty()) continue;
        const double difference = built.levels[i].count() - levels[levels.size() / 2];
        if (std::abs(difference) <= kLevelRange) continue;
        auto& doubt = built.items[i].doubt;
        doubt += fmt::format("{}it is {:.0f} dB {} than the talker's other words",
                             doubt.empty() ? "" : "; ",
                             std::abs(difference),
                             difference > 0 ? "louder" : "weaker");
      }
    }
  }

  static void name_items(Corpus& corpus) {
    std::set<std::string> used;
    for (auto& item : corpus.items) {
      auto name = item.word;
      for (int number = 2; used.contains(name); ++number) {
        name = fmt::format("{}-{}", item.word, number);
      }
      used.insert(name);
      item.name = std::move(name);
    }
  }

  /// What somebody has accepted stays accepted as long as it is the same.
  void keep_verdicts(Corpus& corpus) const {
    const auto near = [](Duration one, Duration other) {
      return std::chrono::abs(one - other) < std::chrono::milliseconds{1};
    };
    for (auto& item : corpus.items) {
      const auto& recording = corpus.recordings[item.recording];
      for (const auto& before : earlier_.items) {
        const bool is_same = before.word == item.word &&
                             earlier_.recordings[before.recording].sha256 == recording.sha256 &&
                             near(before.start, item.start) && near(before.end, item.end) &&
                             pronunciation_of(before) == pronunciation_of(item);
        if (is_same && before.doubt.empty()) item.doubt.clear();
      }
    }
  }

  void tell_of_missing(const Corpus& corpus) {
    std::set<std::string_view> has;
    for (const auto& item : corpus.items) has.insert(item.word);
    std::vector<std::string> missing;
    for (const auto& word : request_.list.words) {
      if (!has.contains(word.spelling)) missing.push_back(word.spelling);
    }
    // Of running speech nobody expects the whole list.
    if (missing.empty() || !by_list_) return;
    find(Severity::Warning,
         request_.folder / kManifestName,
         fmt::format("{} of the list not found: {}",
                     missing.size() == 1 ? "1 word" : fmt::format("{} words", missing.size()),
                     fmt::join(missing, ", ")),
         "record them, or label them in Praat if they are there, and build again");
  }

  const BuildRequest& request_;
  const Progress& progress_;
  Pronouncer pronouncer_;
  CorpusLabels labels_;
  Corpus earlier_;
  std::vector<BuiltRecording> built_;
  bool by_list_ = false;
  BuildReport report_;
};

}  // namespace

BuildReport build_corpus(const BuildRequest& request, const Progress& progress) {
  if (request.list.words.empty()) {
    throw Error{"cannot build a corpus: the list of words is empty; give the words to be taken"};
  }
  return Builder{request, progress}.build();
}

}  // namespace bimodal
