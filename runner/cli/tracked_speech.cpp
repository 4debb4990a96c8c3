#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runner/cli/seen_speech.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/base/json_text.hpp"
#include "stimuli/base/lower_case.hpp"
#include "stimuli/base/nearest.hpp"
#include "stimuli/base/object_reader.hpp"
#include "stimuli/base/obstacle.hpp"
#include "stimuli/labels/label_lines.hpp"
#include "synth/fitting/track_file.hpp"

namespace bimodal::runner {

namespace {

using nlohmann::json;
using synth::Control;
using synth::Track;

constexpr std::size_t kMostValuesOfTracks = 4'000'000;
/// So long, at most, the last instant of tracks is seen: as long as its distance from the one
/// before, where they are sampled evenly.
constexpr Milliseconds kLongestStep{100};

std::string ending_of(const std::string& file) {
  return lower_case(std::filesystem::path{file}.extension().string());
}

std::string text_of(const std::string& file) {
  if (const auto why = obstacle(file)) throw Error{fmt::format("{}: {}", file, *why)};
  return read_file(file);
}

/// "did you mean 'jaw'? " of the first name that is nearly known; else nothing.
std::string nearest_of(const std::vector<std::string>& names,
                       const std::vector<std::string_view>& known) {
  for (const auto& name : names) {
    if (name == "time_ms" || name == "time_s") continue;
    if (const auto near = nearest(name, known)) return fmt::format("did you mean '{}'? ", *near);
  }
  return {};
}

/// Which of the columns' names are controls of the face; tells of the others, but for times and
/// dominances ("jaw@2").
std::vector<std::string> controls_among(const std::vector<std::string>& names,
                                        const std::string& file) {
  std::vector<std::string_view> known;
  for (const auto& row : synth::controls()) known.push_back(row.name);
  std::vector<std::string> found;
  for (const auto& name : names) {
    if (synth::control_from_name(name)) found.push_back(name);
  }
  if (found.empty()) {
    throw Error{fmt::format(
        "{}: none of its columns is a control of the face; {}name them in the first line, without "
        "quotation marks; there are {}",
        file,
        nearest_of(names, known),
        fmt::join(known, ", "))};
  }
  for (const auto& name : names) {
    const bool is_passed_over =
        name == "time_ms" || name == "time_s" || name.find('@') != std::string::npos;
    if (is_passed_over || synth::control_from_name(name)) continue;
    const auto near = nearest(name, known);
    fmt::print(stderr,
               "note: {}: {} is no control of the face and moves nothing{}\n",
               file,
               in_quotes(name),
               near ? fmt::format("; did you mean '{}'?", *near) : "");
  }
  return found;
}

Track track_of_table(const std::string& file) {
  const auto text = text_of(file);
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::string_view rest{text};
  if (rest.starts_with(kByteOrderMark)) rest.remove_prefix(kByteOrderMark.size());
  LineReader lines{rest};
  auto header = lines.next();
  while (header && trimmed(*header).empty()) header = lines.next();
  std::vector<std::string> names;
  while (header) {
    const auto comma = header->find(',');
    names.emplace_back(trimmed(header->substr(0, comma)));
    if (comma == std::string_view::npos) break;
    header->remove_prefix(comma + 1);
  }
  const bool has_names = std::ranges::any_of(names, [](const auto& name) { return !name.empty(); });
  auto wanted = has_names ? controls_among(names, file) : std::vector<std::string>{};
  return synth::parse_track(text, file, {.time_column = {}, .columns = std::move(wanted)});
}

/// The numbers of an array, one for each instant.
std::vector<double> numbers(ObjectReader& reader, std::string_view key, std::size_t fewest) {
  constexpr NumberRule kValue{-1e12, 1e12, "a number, e.g. 0.25"};
  std::vector<double> values;
  for (const auto& [item, pointer] : reader.items(key, fewest, kMostValuesOfTracks)) {
    values.push_back(reader.number_of(*item, pointer, kValue).value_or(0));
  }
  return values;
}

class TracksReader {
 public:
  TracksReader(const json& root, const std::string& file) : root_{root}, file_{file} {}

  SeenSpeech read(Track& track) {
    SeenSpeech seen;
    ObjectReader reader{root_, "", findings_};
    track.file = file_;
    track.time_ms = numbers(reader, "time_ms", 2);
    for (std::size_t i = 1; i < track.time_ms.size(); ++i) {
      if (track.time_ms[i] > track.time_ms[i - 1]) continue;
      findings_.error(fmt::format("/time_ms/{}", i),
                      "it does not come after the instant before it",
                      "put the instants in order, each once");
      break;
    }
    if (auto controls = reader.object("controls")) read_controls(*controls, track);
    for (const auto& [item, pointer] : reader.items("segments", 0, kMostValuesOfTracks)) {
      ObjectReader segment{*item, pointer, findings_};
      constexpr NumberRule kTime{0, 3'600'000, "a time in ms, e.g. 120"};
      const auto symbol = segment.text("symbol", {1, 40, true, "a symbol, e.g. \"S\""});
      const auto start = segment.number("start_ms", kTime);
      const auto duration = segment.number("duration_ms", kTime);
      if (!symbol || !start || !duration) continue;
      seen.centres.push_back({*symbol, Milliseconds{*start + *duration / 2}});
    }
    return seen;
  }

  [[nodiscard]] const Findings& findings() const { return findings_; }

 private:
  void read_controls(ObjectReader& controls, Track& track) {
    const auto& object = root_.at("controls");
    if (!object.is_object()) return;
    std::vector<std::string> names;
    for (const auto& [name, values] : object.items()) names.push_back(name);
    for (const auto& name : controls_among(names, file_)) {
      auto values = numbers(controls, name, 0);
      if (values.size() != track.time_ms.size()) {
        findings_.error(
            "/controls/" + name,
            fmt::format(
                "it has {} values, and there are {} instants", values.size(), track.time_ms.size()),
            "give one for each");
      }
      track.columns.push_back({.name = name, .values = std::move(values)});
    }
  }

  const json& root_;
  const std::string& file_;
  Findings findings_;
};

SeenSpeech read_json(const std::string& file, Track& track) {
  const auto text = text_of(file);
  const auto parsed = parse_json(text, kMostValuesOfTracks);
  TracksReader reader{std::get<json>(parsed), file};
  auto seen = reader.read(track);
  if (reader.findings().all().empty()) return seen;
  std::string messages;
  for (const auto& found : reader.findings().located(JsonLines{text}, file)) {
    messages += (messages.empty() ? "" : "\n") + describe(found);
  }
  throw Error{messages};
}

/// Contacts may go beyond: that only makes them last, or come later.
void tell_limits(const Track& track) {
  for (const auto& column : track.columns) {
    const auto& range = synth::describe(synth::control_from_name(column.name).value());
    const auto [low, high] = std::ranges::minmax(column.values);
    const bool is_within = low >= range.lowest && high <= range.highest;
    if (is_within || synth::makes_contact(range.control)) continue;
    fmt::print(stderr,
               "note: {}: {} goes from {:.4g} to {:.4g}; the face shows {} to {}, and what is "
               "beyond at the limit\n",
               track.file,
               column.name,
               low,
               high,
               range.lowest,
               range.highest);
  }
}

}  // namespace

bool names_tracks(const std::string& file) {
  if (ending_of(file) == ".csv") return true;
  if (ending_of(file) != ".json" || obstacle(file)) return false;
  const auto parsed = parse_json(read_file(file), kMostValuesOfTracks);
  const auto* const root = std::get_if<json>(&parsed);
  return root != nullptr && root->is_object() && root->contains("time_ms") &&
         root->contains("controls");
}

SeenSpeech tracked_speech(const std::string& file) {
  auto track = std::make_shared<Track>();
  SeenSpeech seen;
  if (ending_of(file) == ".json") {
    seen = read_json(file, *track);
  } else {
    *track = track_of_table(file);
  }
  const auto& times = track->time_ms;
  const Milliseconds step{times.back() - times[times.size() - 2]};
  seen.end = Milliseconds{times.back()} + std::min(step, kLongestStep);
  if (seen.end <= Milliseconds{}) {
    throw Error{
        fmt::format("{}: it ends before time 0, where a film begins; count its times from "
                    "the beginning",
                    file)};
  }
  tell_limits(*track);
  std::vector<Control> controls;
  for (const auto& column : track->columns) {
    controls.push_back(synth::control_from_name(column.name).value());
  }
  seen.pose = [track, controls](Milliseconds time) {
    const auto within = std::clamp(time.count(), track->time_ms.front(), track->time_ms.back());
    auto pose = synth::neutral_pose();
    for (std::size_t i = 0; i < controls.size(); ++i) {
      synth::value(pose, controls[i]) = synth::interpolated(*track, track->columns[i], within);
    }
    return pose;
  };
  return seen;
}

}  // namespace bimodal::runner
