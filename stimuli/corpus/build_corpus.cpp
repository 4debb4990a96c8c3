#include "stimuli/corpus/build_corpus.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/corpus/built_recording.hpp"
#include "stimuli/corpus/corpus_folder.hpp"
#include "stimuli/corpus/cut_items.hpp"
#include "stimuli/corpus/earlier_items.hpp"
#include "stimuli/corpus/item_sound.hpp"
#include "stimuli/corpus/labelled_words.hpp"
#include "stimuli/corpus/level_doubts.hpp"
#include "stimuli/corpus/recording_words.hpp"
#include "stimuli/video/media_file.hpp"
#include "stimuli/video/sound_track.hpp"

namespace bimodal {

namespace {

namespace fs = std::filesystem;

double seconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

class Builder {
 public:
  Builder(const BuildRequest& request, const Progress& progress)
      : request_{request},
        progress_{progress},
        pronouncer_{request.list.words},
        labels_{request.folder},
        reader_{request.list.words, request.texts, labels_, pronouncer_, progress} {}

  BuildReport build() {
    read_earlier();
    const auto files = recordings();
    refuse_equal_names(files);
    tell_of_unused_texts(files);
    for (const auto& file : files) {
      try {
        built_.push_back(build_recording(file));
      } catch (const Error& error) {
        failed_.insert((fs::path{"media"} / file.filename()).string());
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

  void tell_of_unused_texts(const std::vector<fs::path>& files) {
    std::vector<std::string> unused;
    for (const auto& given : request_.texts) {
      const bool is_used =
          std::ranges::any_of(files, [&](const auto& file) { return file.stem() == given.first; });
      if (!is_used) unused.push_back(given.first);
    }
    if (unused.empty()) return;
    report_.findings.push_back(
        {Severity::Warning,
         "",
         0,
         "",
         fmt::format("a text is given for '{}', but no such recording", fmt::join(unused, "', '")),
         "write the recording's name as its file has it, without folder and ending"});
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
    const auto [said, text, labels, by_list] = reader_.read(file, sound);
    by_list_ = by_list_ || by_list;
    BuiltRecording built;
    built.running = said.running;
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
    tell_of_change(built.recording, labels);
    const auto name = file.stem().string();
    if (text) labels_.write_text(name, *text);
    if (!labels_.edited(name)) labels_.write(name, labels_of(said, sound.duration()));
    return built;
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

  /// Labels that a hand has made do not follow when the recording is another one.
  void tell_of_change(const Recording& recording, const fs::path& labels) {
    const auto* const before = earlier_recording(recording.file);
    if (before == nullptr || before->sha256 == recording.sha256) return;
    find(Severity::Warning,
         request_.folder / recording.file,
         "it is not the recording from which the corpus was built (its SHA-256 is another)",
         labels.empty() ? "look at its items again"
                        : fmt::format("its labels '{}' were made for the one before: look whether "
                                      "they fit, or remove them to have them made anew",
                                      labels.string()));
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

  void assemble() {
    auto& corpus = report_.corpus;
    corpus.folder = request_.folder;
    const auto folder_name = fs::absolute(request_.folder / ".").parent_path().filename().string();
    corpus.name = request_.name.value_or(earlier_.name.empty() ? folder_name : earlier_.name);
    corpus.description = request_.description.value_or(earlier_.description);
    keep_earlier(corpus);
    doubt_levels(built_);
    for (auto& [recording, items, levels, running] : built_) {
      for (auto& item : items) {
        item.recording = corpus.recordings.size();
        corpus.items.push_back(std::move(item));
      }
      corpus.recordings.push_back(std::move(recording));
    }
    name_items(corpus);
    keep_verdicts(corpus, earlier_);
    tell_of_lost(corpus);
    tell_of_items_elsewhere(corpus);
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
        // Its labels, say, are no longer those from which it came.
        if (failed_.contains(file)) item.doubt = "its recording could not be built again";
        item.recording = corpus.recordings.size();
        corpus.items.push_back(std::move(item));
      }
      corpus.recordings.push_back(earlier_.recordings[i]);
    }
  }

  void tell_of_lost(const Corpus& corpus) {
    auto lost = lost_words(corpus, earlier_);
    std::erase_if(lost, [&](const auto& word) { return !pronouncer_.is_listed(word); });
    if (lost.empty()) return;
    find(Severity::Warning,
         request_.folder / kManifestName,
         fmt::format("{} that the corpus had {} gone: {}",
                     counted(lost.size(), "word"),
                     lost.size() == 1 ? "is" : "are",
                     fmt::join(lost, ", ")),
         "if that is not meant, look at the labels of their recordings");
  }

  void tell_of_items_elsewhere(const Corpus& corpus) {
    const auto elsewhere = items_elsewhere(corpus, earlier_);
    if (elsewhere.empty()) return;
    find(Severity::Warning,
         request_.folder / kManifestName,
         fmt::format("{} by the name of an earlier one: {}",
                     elsewhere.size() == 1 ? "another sound goes" : "other sounds go",
                     fmt::join(elsewhere, ", ")),
         "if sessions have been run with the corpus, build in a new folder");
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
                     counted(missing.size(), "word"),
                     fmt::join(missing, ", ")),
         "record them, or label them in Praat if they are there, and build again");
  }

  const BuildRequest& request_;
  const Progress& progress_;
  Pronouncer pronouncer_;
  CorpusLabels labels_;
  RecordingReader reader_;
  Corpus earlier_;
  std::vector<BuiltRecording> built_;
  std::set<std::string> failed_;  ///< recordings, as the manifest names them
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
