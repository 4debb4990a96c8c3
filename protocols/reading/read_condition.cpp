#include "protocols/reading/read_condition.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "stimuli/audio/time_scale.hpp"
#include "stimuli/base/json_text.hpp"
#include "stimuli/timeline/account.hpp"

namespace bimodal::protocols {

namespace {

using Json = nlohmann::json;
using namespace std::chrono_literals;

constexpr std::size_t kMostConditions = 100;
constexpr std::array<std::string_view, 2> kVoices{"festival:kal", "festival:slt"};
constexpr std::array<std::string_view, 1> kFaces{"face"};

template <typename T>
void take(T& target, std::optional<T> read) {
  if (read) target = std::move(*read);
}

/// Letters, digits and -_. after the prefix.
bool names_corpus(std::string_view talker) {
  if (!is_corpus(talker)) return false;
  const auto name = corpus_name(talker);
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  return !name.empty() && name.front() != '.' && std::ranges::all_of(name, allowed);
}

/// A talker by name: one of the built-in ones, or a corpus.
std::optional<std::string> read_name(ObjectReader& reader,
                                     std::string_view key,
                                     std::span<const std::string_view> built_in,
                                     Findings& findings) {
  const auto* const value = reader.find(key);
  if (value != nullptr && value->is_string() && is_corpus(value->get_ref<const std::string&>())) {
    const auto& name = value->get_ref<const std::string&>();
    if (names_corpus(name) && name.size() <= 100) return name;
    findings.error(reader.pointer_to(key),
                   fmt::format("{} does not name a corpus", shown(*value)),
                   "write \"corpus:NAME\" with letters, digits, - _ . in the name");
    return std::nullopt;
  }
  const auto chosen = reader.choice(key, built_in);
  if (!chosen) return std::nullopt;
  return std::string{built_in[*chosen]};
}

std::optional<int> read_whole(ObjectReader& reader, std::string_view key, const NumberRule& rule) {
  const auto read = reader.whole(key, rule);
  if (!read) return std::nullopt;
  return static_cast<int>(*read);
}

Look read_look(ObjectReader& parent, Findings& findings) {
  Look look;
  auto reader = parent.object("look");
  if (!reader) return look;
  if (reader->has("like")) take(look.like, read_name(*reader, "like", kFaces, findings));
  if (const auto rate = reader->number(
          "frame_rate_hz", {1, 240, "how often the picture may change in a second, e.g. 25"})) {
    look.frame_rate = Hertz{*rate};
  }
  look.lines = read_whole(*reader, "lines", {32, 8'192, "a number of picture lines, e.g. 288"});
  look.height = read_whole(*reader, "height", {64, 8'192, "a number of pixels, e.g. 720"});
  take(look.blur_px, reader->number("blur_px", {0, 50, "a number of pixels, e.g. 1.5"}));
  look.background = read_colour(*reader, "background", findings);
  reader->refuse_unknown_keys();
  return look;
}

/// The keys "coarticulation" and "segments".
Articulating read_articulating(ObjectReader& reader) {
  Articulating articulating;
  std::vector<std::string_view> names;
  for (const auto& row : accounts()) names.push_back(row.name);
  if (const auto chosen = reader.choice("coarticulation", names)) {
    articulating.account = accounts()[*chosen].account;
  }
  take(articulating.segments,
       reader.text("segments",
                   {.shortest = 1,
                    .longest = 500,
                    .meaning = "an inventory of segments: the name of one that ships, e.g. "
                               "\"turkish-plateau\", or the path of a file relative to the "
                               "protocol"}));
  return articulating;
}

/// Keys that only the synthetic face has.
void refuse_for_recordings(ObjectReader& reader, Findings& findings) {
  for (const auto* key : {"coarticulation", "segments", "face"}) {
    if (!reader.has(key)) continue;
    findings.error(reader.pointer_to(key),
                   "recordings articulate and look in their own way",
                   "remove it, or let \"face\" be seen");
  }
}

/// The keys of who is seen, beside the talker; `is_face`: it is, or may be, the synthetic face.
using ReadSeen = std::function<void(ObjectReader& visual, bool is_face)>;

struct WrittenTalker {
  std::optional<std::string> name;
  std::string otherwise;
};

/// {"talker": "festival:kal"}, or null or nothing for none. `read_seen` reads what else is said of
/// who is seen.
WrittenTalker read_talker(ObjectReader& parent,
                          std::string_view key,
                          std::span<const std::string_view> built_in,
                          Findings& findings,
                          const ReadSeen& read_seen = {}) {
  WrittenTalker talker;
  const auto* value = parent.find(key);
  if (value == nullptr || value->is_null()) return talker;
  auto reader = *parent.object(key);
  reader.require("talker", fmt::format("\"{}\" or \"corpus:NAME\"", built_in.front()));
  talker.name = read_name(reader, "talker", built_in, findings);
  if (const auto otherwise = reader.choice("otherwise", built_in)) {
    talker.otherwise = built_in[*otherwise];
    if (talker.name && !is_corpus(*talker.name)) {
      findings.error(
          reader.pointer_to("otherwise"),
          fmt::format("{} is always there, so nobody takes its place", shown(Json(*talker.name))),
          "remove it, or name a corpus as the talker");
    }
  }
  const bool may_be_built_in =
      !talker.name || !is_corpus(*talker.name) || !talker.otherwise.empty();
  if (read_seen) read_seen(reader, may_be_built_in);
  reader.refuse_unknown_keys();
  return talker;
}

std::optional<Gate> read_gate(ObjectReader& parent, Findings& findings) {
  auto reader = parent.object("gate");
  if (!reader) return std::nullopt;
  Gate gate;
  gate.at = reader->time(
      "at_ms", 1ms, {1, 60'000, "milliseconds since the onset of the speech, e.g. 120"});
  take(gate.after_phone,
       read_whole(*reader, "after_phone", {1, 100, "the number of a phone, from 1"}));
  constexpr std::array<std::string_view, 2> kPictures{"blank", "freeze"};
  if (const auto picture = reader->choice("picture", kPictures)) {
    gate.picture = static_cast<AfterGate>(*picture);
  }
  const bool both = reader->has("at_ms") && reader->has("after_phone");
  const bool none = !reader->has("at_ms") && !reader->has("after_phone");
  if (both || none) {
    findings.error(reader->pointer(),
                   both ? "two gates" : "a gate without a place",
                   "give \"at_ms\" or \"after_phone\", one of the two");
  }
  reader->refuse_unknown_keys();
  return gate;
}

Manner read_manner(ObjectReader& parent, Findings& findings) {
  Manner manner;
  auto reader = parent.object("manner");
  if (!reader) return manner;
  take(manner.rate,
       reader->number("rate", {kSlowest, kFastest, "how many times as fast, 0.25 to 4, e.g. 3"}));
  take(manner.reversed, reader->flag("reversed"));
  manner.gate = read_gate(*reader, findings);
  reader->refuse_unknown_keys();
  return manner;
}

/// Whether the talkers and the ratio of one condition go together; what is faulty is left alone.
void judge_talkers(const ObjectReader& reader,
                   const Condition& condition,
                   bool has_timing,
                   Findings& findings) {
  if (findings.faulty(reader.pointer_to("auditory"))) return;
  const bool seen_recording = condition.visual_talker && is_corpus(*condition.visual_talker);
  if (has_timing && (condition.auditory_talker || seen_recording)) {
    findings.error(reader.pointer_to("timing"),
                   condition.auditory_talker ? "where a voice is heard, that voice times the face"
                                             : "a recording that is seen has its own time",
                   "remove \"timing\"");
  }
  if (condition.auditory_talker) return;
  if (!condition.visual_talker && !findings.faulty(reader.pointer_to("visual"))) {
    findings.error(reader.pointer(),
                   "nothing is heard and nothing is seen",
                   "give \"auditory\" or \"visual\" or both a talker");
  }
  if (condition.snr) {
    findings.error(reader.pointer_to("snr_db"),
                   "there is a speech-to-noise ratio but no speech",
                   "remove it, or give \"auditory\" a talker");
  }
}

WrittenCondition read_condition(const Json& value,
                                std::string pointer,
                                const Face& usual,
                                const FaceReader& faces,
                                Findings& findings) {
  WrittenCondition written{.condition = {},
                           .pointer = pointer,
                           .auditory_otherwise = {},
                           .visual_otherwise = {},
                           .timing_otherwise = {}};
  auto& condition = written.condition;
  ObjectReader reader{value, std::move(pointer), findings};
  const TextRule name{.shortest = 1,
                      .longest = 40,
                      .meaning = "a short name, e.g. \"bimodal\"; tables and figures show it"};
  reader.require("name", "\"bimodal\"");
  take(condition.name, reader.text("name", name));
  take(condition.optional, reader.flag("optional"));
  auto auditory = read_talker(reader, "auditory", kVoices, findings);
  condition.face = usual;
  const auto read_seen = [&](ObjectReader& visual, bool is_face) {
    condition.look = read_look(visual, findings);
    condition.articulating = read_articulating(visual);
    condition.face = faces.read(visual, usual);
    if (!is_face) refuse_for_recordings(visual, findings);
  };
  auto visual = read_talker(reader, "visual", kFaces, findings, read_seen);
  auto timing = read_talker(reader, "timing", kVoices, findings);
  condition.auditory_talker = std::move(auditory.name);
  condition.visual_talker = std::move(visual.name);
  written.auditory_otherwise = std::move(auditory.otherwise);
  written.visual_otherwise = std::move(visual.otherwise);
  const bool has_timing = timing.name.has_value();
  if (condition.auditory_talker) {
    condition.timing_talker = *condition.auditory_talker;
    written.timing_otherwise = written.auditory_otherwise;
  } else if (condition.visual_talker && is_corpus(*condition.visual_talker)) {
    condition.timing_talker = *condition.visual_talker;
  } else if (has_timing) {
    condition.timing_talker = *timing.name;
    written.timing_otherwise = std::move(timing.otherwise);
  }
  const auto* snr = reader.find("snr_db");
  if (snr != nullptr && !snr->is_null()) {
    const auto ratio = reader.number("snr_db", {-60, 60, "the ratio in dB, e.g. -8"});
    if (ratio) condition.snr = Decibels{*ratio};
  }
  condition.av_offset = reader.time(
      "av_offset_ms",
      1ms,
      {-1'000, 1'000, "audio minus visual in milliseconds, e.g. 100: the sound lags by 100 ms"});
  condition.manner = read_manner(reader, findings);
  judge_talkers(reader, condition, has_timing, findings);
  reader.refuse_unknown_keys();
  return written;
}

}  // namespace

std::vector<WrittenCondition> read_conditions(ObjectReader& parent,
                                              const Face& usual,
                                              const FaceReader& faces,
                                              Findings& findings) {
  std::vector<WrittenCondition> conditions;
  for (const auto& [item, pointer] : parent.items("conditions", 1, kMostConditions)) {
    conditions.push_back(read_condition(*item, pointer, usual, faces, findings));
  }
  return conditions;
}

std::optional<std::uint32_t> read_colour(ObjectReader& reader,
                                         std::string_view key,
                                         Findings& findings) {
  const auto written = reader.text(key, {.longest = 40, .meaning = "a colour, e.g. \"#606060\""});
  if (!written) return std::nullopt;
  constexpr std::size_t kLength = 7;
  std::uint32_t colour = 0;
  bool good = written->size() == kLength && written->front() == '#';
  if (good) {
    const char* end = written->data() + written->size();
    const auto [stopped, fault] = std::from_chars(written->data() + 1, end, colour, 16);
    good = fault == std::errc{} && stopped == end;
  }
  if (good) return colour;
  findings.error(reader.pointer_to(key),
                 fmt::format("{} is not a colour", shown(Json(*written))),
                 "give red, green, blue in two hexadecimal digits each, e.g. \"#606060\"");
  return std::nullopt;
}

}  // namespace bimodal::protocols
