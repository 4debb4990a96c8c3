#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/draft.hpp"
#include "stimuli/corpus/corpus.hpp"

namespace bimodal {

namespace {

/// Seconds with up to six decimals.
std::string seconds_text(Duration time) {
  auto text = fmt::format("{:.6f}", std::chrono::duration<double>{time}.count());
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text += '0';
  return text;
}

std::string as_json(const std::string& text) {
  return nlohmann::json(text).dump();
}

std::string line_of(const Recording& recording) {
  return fmt::format(R"({{"file": {}, "sha256": {}, "talker": {}, "licence": {}{}}})",
                     as_json(recording.file),
                     as_json(recording.sha256),
                     as_json(recording.talker),
                     as_json(recording.licence),
                     recording.eye_distance_px
                         ? fmt::format(R"(, "eye_distance_px": {:g})", *recording.eye_distance_px)
                         : std::string{});
}

std::string line_of(const CorpusItem& item, const Corpus& corpus) {
  std::string phones;
  std::string times;
  for (const auto& phone : item.phones) {
    phones += fmt::format("{}{}", phones.empty() ? "" : " ", symbol(phone.phone));
    times += seconds_text(phone.start) + ", ";
  }
  times += seconds_text(item.phones.back().end());
  return fmt::format(
      R"({{"item": {}, "word": {}, "recording": {}, "start_s": {}, "end_s": {}, "phones": {}, "times_s": [{}]{}{}{}}})",
      as_json(item.name),
      as_json(item.word),
      as_json(corpus.recordings.at(item.recording).file),
      seconds_text(item.start),
      seconds_text(item.end),
      as_json(phones),
      times,
      item.clear ? fmt::format(R"(, "clear_s": [{}, {}])",
                               seconds_text(item.clear->start),
                               seconds_text(item.clear->end))
                 : std::string{},
      item.doubt.empty() ? std::string{} : fmt::format(R"(, "doubt": {})", as_json(item.doubt)),
      item.accepted.empty() ? std::string{}
                            : fmt::format(R"(, "accepted": {})", as_json(item.accepted)));
}

}  // namespace

void write_corpus(const Corpus& corpus) {
  std::string text = fmt::format(
      "{{\n  \"bimodal_corpus\": {},\n  \"name\": {},\n  \"description\": {},\n  \"recordings\": [",
      kManifestFormat,
      as_json(corpus.name),
      as_json(corpus.description));
  const char* before = "\n    ";
  for (const auto& recording : corpus.recordings) {
    text += before + line_of(recording);
    before = ",\n    ";
  }
  text += "\n  ],\n  \"items\": [";
  before = "\n    ";
  for (const auto& item : corpus.items) {
    text += before + line_of(item, corpus);
    before = ",\n    ";
  }
  text += "\n  ]\n}\n";
  write_file(corpus.folder / kManifestName, text);
}

}  // namespace bimodal
