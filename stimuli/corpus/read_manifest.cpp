#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/base/json_lines.hpp"
#include "stimuli/base/json_text.hpp"
#include "stimuli/base/object_reader.hpp"
#include "stimuli/base/obstacle.hpp"
#include "stimuli/corpus/corpus.hpp"

namespace bimodal {

namespace {

using Json = nlohmann::json;
using namespace std::chrono_literals;

constexpr std::size_t kMostRecordings = 20'000;
constexpr std::size_t kMostItems = 20'000;
constexpr std::size_t kMostPhones = 500;
constexpr double kLatest = 14'400.0;  ///< seconds into a recording
constexpr NumberRule kSeconds{
    0.0, kLatest, "a time in seconds from the recording's zero, e.g. 12.35"};

/// Whether a path stays within the folder that it is relative to.
bool stays_inside(const std::filesystem::path& path) {
  if (path.empty() || path.is_absolute()) return false;
  for (const auto& part : path) {
    if (part == "..") return false;
  }
  return true;
}

class ManifestReader {
 public:
  explicit ManifestReader(Findings& findings) : findings_{findings} {}

  void read(const Json& json, Corpus& corpus) {
    ObjectReader reader{json, "", findings_};
    reader.require("bimodal_corpus", "1 (the format of this file)");
    const auto format = reader.whole("bimodal_corpus", {1, 1e9, "the format of this file: 1"});
    if (format && *format > kManifestFormat) {
      findings_.error("/bimodal_corpus",
                      fmt::format("written for a newer Bimodal: format {}", *format),
                      "update Bimodal");
      return;
    }
    reader.require("name", "\"my-talker\"");
    corpus.name = reader.text("name", {.shortest = 1, .longest = 100, .meaning = "a short name"})
                      .value_or("");
    corpus.description =
        reader
            .text("description", {.longest = 10'000, .one_line = false, .meaning = "a description"})
            .value_or("");
    for (const auto& [value, pointer] : reader.items("recordings", 1, kMostRecordings)) {
      read_recording(*value, pointer, corpus);
    }
    reader.require("recordings", "[ { \"file\": \"media/reading.wav\", ... } ]");
    for (const auto& [value, pointer] : reader.items("items", 0, kMostItems)) {
      read_item(*value, pointer, corpus);
    }
    reader.require("items", "[ { \"item\": \"stew\", \"word\": \"stew\", ... } ]");
    reader.refuse_unknown_keys();
  }

 private:
  void read_recording(const Json& value, const std::string& pointer, Corpus& corpus) {
    ObjectReader reader{value, pointer, findings_};
    Recording recording;
    reader.require("file", "\"media/reading.wav\"");
    reader.require("sha256", "the SHA-256 of the file; `sha256sum` prints it");
    reader.require("talker", "\"speaker 1\"");
    recording.file =
        reader
            .text("file",
                  {.shortest = 1, .longest = 1'000, .meaning = "a path within the corpus's folder"})
            .value_or("");
    recording.sha256 = reader.text("sha256", {.meaning = "64 hexadecimal digits"}).value_or("");
    recording.talker =
        reader.text("talker", {.shortest = 1, .longest = 100, .meaning = "a name"}).value_or("");
    recording.licence =
        reader.text("licence", {.meaning = "the licence, e.g. \"CC BY 4.0\""}).value_or("");
    recording.eye_distance_px = reader.number(
        "eye_distance_px", {1, 10'000, "the distance of the outer eye corners in pixels, e.g. 70"});
    reader.refuse_unknown_keys();
    judge_recording(recording, pointer);
    recording_of_.emplace(recording.file, corpus.recordings.size());
    corpus.recordings.push_back(std::move(recording));
  }

  void judge_recording(const Recording& recording, const std::string& pointer) {
    if (!recording.file.empty() && !stays_inside(recording.file)) {
      findings_.error(pointer + "/file",
                      fmt::format("{} leads out of the corpus's folder", shown(recording.file)),
                      "put the file into the folder and give its path within it");
    }
    const bool is_digest =
        recording.sha256.size() == 64 &&
        recording.sha256.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!recording.sha256.empty() && !is_digest) {
      findings_.error(pointer + "/sha256",
                      fmt::format("{} is no SHA-256", shown(recording.sha256)),
                      "give 64 hexadecimal digits in lower case; `sha256sum` prints them");
    }
    if (recording_of_.contains(recording.file)) {
      findings_.error(pointer + "/file",
                      fmt::format("{} is named twice", shown(recording.file)),
                      "remove one of the two");
    }
  }

  void read_item(const Json& value, const std::string& pointer, Corpus& corpus) {
    ObjectReader reader{value, pointer, findings_};
    CorpusItem item;
    reader.require("item", "\"stew\"");
    reader.require("word", "\"stew\"");
    reader.require("recording", "the \"file\" of one of the recordings");
    reader.require("start_s", "12.35");
    reader.require("end_s", "13.1");
    reader.require("phones", "\"S T UW\"");
    reader.require("times_s", "where each phone begins and the last one ends, [12.5, 12.62, ...]");
    item.name = reader.text("item", {.shortest = 1, .longest = 200, .meaning = "a name of its own"})
                    .value_or("");
    item.word =
        reader.text("word", {.shortest = 1, .longest = 4'000, .meaning = "what is said, \"stew\""})
            .value_or("");
    item.doubt = reader.text("doubt", {.meaning = "why it should be looked at"}).value_or("");
    item.accepted =
        reader.text("accepted", {.meaning = "the doubt that somebody has taken away"}).value_or("");
    const auto file = reader.text("recording", {.meaning = "the \"file\" of a recording"});
    const auto start = reader.time("start_s", 1s, kSeconds);
    const auto end = reader.time("end_s", 1s, kSeconds);
    const auto phones =
        reader.text("phones", {.shortest = 1, .longest = 4'000, .meaning = "\"S T UW\""});
    const auto times = read_times(reader, "times_s", kMostPhones + 1);
    const auto clear = reader.has("clear_s") ? read_times(reader, "clear_s", 2) : std::nullopt;
    reader.refuse_unknown_keys();
    if (!item.name.empty() && !names_.insert(item.name).second) {
      findings_.error(pointer + "/item",
                      fmt::format("{} names two items", shown(item.name)),
                      "give each item a name of its own");
    }
    if (!file || !start || !end || !phones || !times) return;
    const auto recording = recording_of_.find(*file);
    if (recording == recording_of_.end()) {
      findings_.error(pointer + "/recording",
                      fmt::format("there is no recording {}", shown(*file)),
                      "give the \"file\" of one that stands in \"recordings\"");
      return;
    }
    item.recording = recording->second;
    item.start = *start;
    item.end = *end;
    if (clear) item.clear = SpeechInterval{clear->front(), clear->back()};
    if (take_phones(*phones, *times, pointer, item) && judge_times(item, pointer)) {
      corpus.items.push_back(std::move(item));
    }
  }

  std::optional<std::vector<Duration>> read_times(ObjectReader& reader,
                                                  std::string_view key,
                                                  std::size_t most) {
    std::vector<Duration> times;
    bool good = true;
    for (const auto& [value, pointer] : reader.items(key, 2, most)) {
      const auto seconds = reader.number_of(*value, pointer, kSeconds);
      good = good && seconds.has_value();
      times.emplace_back(std::llround(seconds.value_or(0.0) * 1e9));
    }
    if (!good || times.empty()) return std::nullopt;
    return times;
  }

  bool take_phones(const std::string& symbols,
                   const std::vector<Duration>& times,
                   const std::string& pointer,
                   CorpusItem& item) {
    std::size_t from = 0;
    std::vector<Phone> phones;
    while (from < symbols.size()) {
      const auto blank = std::min(symbols.find(' ', from), symbols.size());
      const auto symbol = std::string_view{symbols}.substr(from, blank - from);
      from = blank + 1;
      if (symbol.empty()) continue;
      const auto phone = phone_from_symbol(symbol);
      if (!phone) {
        findings_.error(pointer + "/phones",
                        fmt::format("{} is not a phone", shown(std::string{symbol})),
                        fmt::format("use the symbols {}, and \"rest\" between words",
                                    spell(all_phones().subspan(1))));
        return false;
      }
      phones.push_back(*phone);
    }
    if (times.size() != phones.size() + 1) {
      findings_.error(pointer + "/times_s",
                      fmt::format("{} times for {} phones", times.size(), phones.size()),
                      "give the start of each phone and the end of the last one");
      return false;
    }
    for (std::size_t i = 0; i < phones.size(); ++i) {
      item.phones.push_back({phones[i], times[i], times[i + 1] - times[i]});
    }
    return true;
  }

  bool judge_times(const CorpusItem& item, const std::string& pointer) {
    const auto refuse = [&](const char* key, std::string finding, std::string remedy) {
      findings_.error(pointer + key, std::move(finding), std::move(remedy));
      return false;
    };
    for (const auto& phone : item.phones) {
      if (phone.duration > Duration{}) continue;
      return refuse("/times_s",
                    fmt::format("{} ends before it begins, or at once", symbol(phone.phone)),
                    "give times that increase");
    }
    if (item.phones.front().phone == Phone::Rest || item.phones.back().phone == Phone::Rest) {
      return refuse("/phones",
                    "the item begins or ends with rest",
                    "leave that out; \"start_s\" and \"end_s\" say where the margins are");
    }
    if (item.start >= item.end) {
      return refuse("/end_s", "the item ends before it begins", "give a later end");
    }
    if (item.phones.front().start < item.start || item.phones.back().end() > item.end) {
      return refuse("/times_s",
                    "a phone stands outside of the item",
                    "widen \"start_s\" and \"end_s\", or mend the times");
    }
    if (item.clear && (item.clear->start < item.start || item.clear->end > item.end ||
                       item.clear->start >= item.clear->end)) {
      return refuse("/clear_s",
                    "what is clear of other words is not within the item",
                    "give two times between \"start_s\" and \"end_s\", or leave the key out");
    }
    return true;
  }

  Findings& findings_;
  std::map<std::string, std::size_t> recording_of_;
  std::set<std::string> names_;
};

}  // namespace

Corpus parse_corpus(std::string_view text,
                    const std::filesystem::path& file,
                    std::vector<Diagnostic>& diagnostics) {
  Corpus corpus;
  corpus.folder = file.parent_path();
  const auto parsed = parse_json(text);
  if (const auto* fault = std::get_if<TextFault>(&parsed)) {
    diagnostics.push_back(
        {Severity::Error, file.string(), fault->line, "", fault->finding, fault->remedy});
    return corpus;
  }
  const JsonLines lines{text};
  Findings findings;
  findings.refuse_duplicates(lines);
  ManifestReader{findings}.read(std::get<Json>(parsed), corpus);
  const auto located = findings.located(lines, file.string());
  diagnostics.insert(diagnostics.end(), located.begin(), located.end());
  corpus.sha256 = sha256(text);
  return corpus;
}

Corpus read_corpus(const std::filesystem::path& place, std::vector<Diagnostic>& diagnostics) {
  std::error_code ignored;
  const auto file = std::filesystem::is_directory(place, ignored) ? place / kManifestName : place;
  const auto refuse = [&](std::string finding) {
    diagnostics.push_back({Severity::Error,
                           file.string(),
                           0,
                           "",
                           std::move(finding),
                           "give the folder of a corpus; `bimodal corpus build` makes one"});
    Corpus corpus;
    corpus.folder = file.parent_path();
    return corpus;
  };
  if (const auto reason = obstacle(file)) return refuse("cannot read the corpus: " + *reason);
  try {
    return parse_corpus(read_file(file), file, diagnostics);
  } catch (const Error& error) {
    return refuse(describe(error));
  }
}

}  // namespace bimodal
