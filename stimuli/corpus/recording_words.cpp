#include "stimuli/corpus/recording_words.hpp"

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "stimuli/corpus/hear_text.hpp"
#include "stimuli/corpus/labelled_words.hpp"
#include "stimuli/labels/label_file.hpp"

namespace bimodal {

namespace fs = std::filesystem;

RecordingReader::RecordingReader(std::span<const Word> list,
                                 const Texts& texts,
                                 const CorpusLabels& labels,
                                 Pronouncer& pronouncer,
                                 const Progress& progress)
    : list_{list},
      texts_{&texts},
      labels_{&labels},
      pronouncer_{&pronouncer},
      progress_{&progress} {}

RecordingWords RecordingReader::read(const fs::path& recording, const Clip& sound) {
  const auto name = recording.stem().string();
  if (labels_->edited(name)) return labelled(labels_->file_of(name), sound);
  for (const auto* const ending : {".TextGrid", ".lab", ".align"}) {
    auto beside = recording;
    beside.replace_extension(ending);
    std::error_code ignored;
    if (fs::exists(beside, ignored)) return labelled(beside, sound);
  }
  if (auto text = text_of(recording)) {
    std::vector<SpokenWord> words;
    for (const auto& word : *text) words.push_back(pronouncer_->pronounce(word));
    return {.said = hear_text(sound, words), .text = std::move(text)};
  }
  return {.said = hear_list(sound, list_, *progress_), .by_list = true};
}

RecordingWords RecordingReader::labelled(const fs::path& labels, const Clip& sound) {
  try {
    return {.said = labelled_words(read_labels(labels), sound, list_, *pronouncer_),
            .labels = labels};
  } catch (const Error&) {
    std::throw_with_nested(Error{fmt::format("using the labels '{}'", labels.string())});
  }
}

std::optional<std::vector<std::string>> RecordingReader::text_of(const fs::path& recording) const {
  const auto name = recording.stem().string();
  if (const auto given = texts_->find(name); given != texts_->end()) return given->second;
  auto beside = recording;
  beside.replace_extension(".txt");
  for (const auto& text : {beside, labels_->text_file_of(name)}) {
    std::error_code ignored;
    if (fs::exists(text, ignored)) return read_text(text);
  }
  return std::nullopt;
}

}  // namespace bimodal
