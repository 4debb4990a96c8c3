#include "protocols/reading/structure.hpp"

#include <array>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "protocols/reading/read_condition.hpp"
#include "protocols/reading/read_response.hpp"
#include "protocols/reading/read_sound.hpp"
#include "protocols/reading/read_timing.hpp"
#include "protocols/reading/read_triggers.hpp"
#include "stimuli/base/json_text.hpp"
#include "stimuli/base/lower_case.hpp"
#include "stimuli/base/object_reader.hpp"

namespace bimodal::protocols {

namespace {

using Json = nlohmann::json;
using namespace std::chrono_literals;

constexpr std::size_t kMostPages = 100;
constexpr std::size_t kMostWords = 10'000;
constexpr NumberRule kSeconds{0, 60, "a time in seconds, e.g. 0.5"};

constexpr std::array<std::string_view, 2> kAssignments{"once", "every-condition"};
constexpr std::array<std::string_view, 3> kFaceQualities{"auto", "fast", "full"};

/// Replaces a default by what was read, if anything was.
template <typename T>
void take(T& target, std::optional<T> read) {
  if (read) target = std::move(*read);
}

void take_whole(int& target, std::optional<std::int64_t> read) {
  if (read) target = static_cast<int>(*read);
}

/// ["B", "AA"] or ["B~W:3/8", "AA"]; noted and empty where something is no phone.
SpelledSegments read_phones(ObjectReader& reader, Findings& findings) {
  std::vector<Segment> segments;
  for (const auto& [value, pointer] : reader.items("phones", 1, 100)) {
    const auto read = parse_sound(value->is_string() ? value->get_ref<const std::string&>() : "");
    if (const auto* const fault = std::get_if<SegmentFault>(&read)) {
      findings.error(
          pointer,
          value->is_string() ? fault->finding : fmt::format("{} is not a phone", shown(*value)),
          fault->remedy);
    } else {
      segments.push_back(std::get<Segment>(read));
    }
  }
  return spelled(segments);
}

constexpr TextRule kWordRule{.shortest = 1, .longest = 40, .meaning = "a word, e.g. \"cat\""};

/// "da", or {"word": "da", "phones": ["D", "AA"]}, under "seen".
void read_seen(ObjectReader& parent, WrittenWord& word, Findings& findings) {
  const auto* const value = parent.find("seen");
  if (value == nullptr || !value->is_object()) {
    word.seen = lower_case(parent.text("seen", kWordRule).value_or(""));
    return;
  }
  auto reader = *parent.object("seen");
  reader.require("word", "\"da\"");
  word.seen = lower_case(reader.text("word", kWordRule).value_or(""));
  word.seen_said = read_phones(reader, findings);
  reader.refuse_unknown_keys();
}

/// "cat", or {"word": "ba", "phones": ["B", "AA"], "seen": "da"}.
std::optional<WrittenWord> read_word(ObjectReader& parent,
                                     const Json& value,
                                     const std::string& pointer,
                                     Findings& findings) {
  WrittenWord word;
  word.pointer = pointer;
  if (!value.is_object()) {
    const auto spelling = parent.text_of(value, pointer, kWordRule);
    if (!spelling) return std::nullopt;
    word.spelling = lower_case(*spelling);
    return word;
  }
  ObjectReader reader{value, pointer, findings};
  reader.require("word", "\"ba\"");
  const auto spelling = reader.text("word", kWordRule);
  word.said = read_phones(reader, findings);
  read_seen(reader, word, findings);
  reader.refuse_unknown_keys();
  if (!spelling || findings.faulty(pointer)) return std::nullopt;
  word.spelling = lower_case(*spelling);
  if (!word.seen_said.phones.empty() && word.seen == word.spelling) {
    findings.error(pointer + "/seen/word",
                   fmt::format("{} is the name of what is heard too", shown(word.seen)),
                   "give what is seen a name of its own");
    return std::nullopt;
  }
  return word;
}

/// A name or path, or an array of words.
std::optional<WordChoice> read_words(ObjectReader& reader,
                                     std::string_view key,
                                     Findings& findings) {
  const auto* value = reader.find(key);
  if (value == nullptr) return std::nullopt;
  WordChoice choice{.pointer = reader.pointer_to(key), .list = {}, .words = {}};
  if (!value->is_array()) {
    const TextRule name{.shortest = 1,
                        .longest = 500,
                        .meaning =
                            "the name of a word list of the library, e.g. "
                            "\"monosyllables-414\", the path of a word list relative to the "
                            "protocol, or an array of words, e.g. [\"cat\", \"dog\"]"};
    auto list = reader.text(key, name);
    if (!list) return std::nullopt;
    choice.list = std::move(*list);
    return choice;
  }
  for (const auto& [item, pointer] : reader.items(key, 1, kMostWords)) {
    if (auto word = read_word(reader, *item, pointer, findings)) {
      choice.words.push_back(std::move(*word));
    }
  }
  return choice;
}

std::optional<WordChoice> read_practice(ObjectReader& parent, Findings& findings) {
  auto reader = parent.object("practice");
  if (!reader) return std::nullopt;
  reader->require("words", "[\"cat\", \"dog\"]");
  auto words = read_words(*reader, "words", findings);
  reader->refuse_unknown_keys();
  return words;
}

void read_breaks(ObjectReader& parent, Breaks& breaks) {
  auto reader = parent.object("breaks");
  if (!reader) return;
  reader->require("every_trials", "100");
  take_whole(
      breaks.every_trials,
      reader->whole("every_trials",
                    {0, 10'000, "the number of trials from break to break, e.g. 100; 0 for none"}));
  take(breaks.text, reader->text("text", {.one_line = false, .meaning = "a text to show"}));
  reader->refuse_unknown_keys();
}

void read_intervals(ObjectReader& parent, Intervals& intervals) {
  auto reader = parent.object("intervals");
  if (!reader) return;
  take(intervals.fixation, reader->time("fixation_s", 1s, kSeconds));
  take(intervals.lead, reader->time("lead_s", 1s, kSeconds));
  take(intervals.trail, reader->time("trail_s", 1s, kSeconds));
  take(intervals.pause, reader->time("pause_s", 1s, kSeconds));
  take(intervals.av_offset,
       reader->time("av_offset_ms",
                    1ms,
                    {-1'000,
                     1'000,
                     "audio minus visual in milliseconds, e.g. 100: the sound lags by 100 ms"}));
  reader->refuse_unknown_keys();
}

void read_window(ObjectReader& parent, Window& window, Findings& findings) {
  auto reader = parent.object("window");
  if (!reader) return;
  constexpr NumberRule kPixels{320, 8'192, "a number of pixels, e.g. 1024"};
  take_whole(window.width, reader->whole("width", kPixels));
  take_whole(window.height, reader->whole("height", kPixels));
  take(window.fullscreen, reader->flag("fullscreen"));
  take_whole(window.face_height,
             reader->whole("face_height", {64, 8'192, "a number of pixels, e.g. 720"}));
  take(window.background, read_colour(*reader, "background", findings));
  const auto quality = reader->choice("face_quality", kFaceQualities);
  if (quality) window.face_quality = static_cast<FaceQuality>(*quality);
  reader->refuse_unknown_keys();
}

/// Whether the rest may be read.
bool judge_format(ObjectReader& reader, Findings& findings) {
  const NumberRule format{1, 1e9, "the format of this file: 1"};
  if (reader.require("bimodal_protocol", "1 (the format of this file)") == nullptr) return true;
  const auto written = reader.whole("bimodal_protocol", format);
  if (!written || *written <= kProtocolFormat) return true;
  findings.error(reader.pointer_to("bimodal_protocol"),
                 fmt::format("written for a newer Bimodal: format {}, and this one reads up to {}",
                             *written,
                             kProtocolFormat),
                 "update Bimodal");
  return false;
}

void read_texts(ObjectReader& reader, Protocol& protocol) {
  reader.require("title", "\"My experiment\"");
  take(protocol.title,
       reader.text("title", {.shortest = 1, .longest = 200, .meaning = "a title of one line"}));
  take(protocol.description,
       reader.text("description",
                   {.longest = 10'000, .one_line = false, .meaning = "a description"}));
  for (const auto& [item, pointer] : reader.items("instructions", 0, kMostPages)) {
    auto page = reader.text_of(
        *item, pointer, {.shortest = 1, .one_line = false, .meaning = "the text of one page"});
    if (page) protocol.instructions.push_back(std::move(*page));
  }
  take(protocol.farewell,
       reader.text("farewell", {.one_line = false, .meaning = "a text to show at the end"}));
}

}  // namespace

Structure read_structure(const Json& json, const FaceReader& faces, Findings& findings) {
  Structure structure;
  auto& protocol = structure.protocol;
  ObjectReader reader{json, "", findings};
  if (!judge_format(reader, findings)) return structure;
  static_cast<void>(
      reader.text("$schema", {.longest = 500, .meaning = "the address of the schema"}));
  read_texts(reader, protocol);
  reader.require("seed", "1993 (any whole number; it decides everything that is random)");
  const auto seed = reader.whole("seed", {0, 9007199254740991.0, "a whole number, e.g. 1993"});
  if (seed) protocol.seed = static_cast<Seed>(*seed);
  reader.require("words", "\"monosyllables-414\"");
  structure.words = read_words(reader, "words", findings);
  if (structure.words) protocol.words = structure.words->list;
  reader.require("conditions", "[ { \"name\": ..., \"auditory\": ..., \"visual\": ... } ]");
  protocol.face = faces.read(reader, {});
  structure.conditions = read_conditions(reader, protocol.face, faces, findings);
  const auto assignment = reader.choice("assignment", kAssignments);
  if (assignment) protocol.assignment = static_cast<Assignment>(*assignment);
  structure.practice = read_practice(reader, findings);
  if (structure.practice) protocol.practice.list = structure.practice->list;
  read_breaks(reader, protocol.breaks);
  protocol.response = read_response(reader, findings);
  read_intervals(reader, protocol.intervals);
  read_sound(reader, protocol.sound, findings);
  read_window(reader, protocol.window, findings);
  protocol.timing = read_timing(reader);
  protocol.triggers = read_triggers(reader, findings);
  reader.refuse_unknown_keys();
  return structure;
}

}  // namespace bimodal::protocols
