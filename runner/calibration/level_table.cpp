#include "runner/calibration/level_table.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/located_reading.hpp"
#include "stimuli/base/object_reader.hpp"
#include "stimuli/base/obstacle.hpp"

namespace bimodal::runner {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostLevels = 1'000;

void read_frequencies(ObjectReader& reader, MeasuredLevel& level, Findings& findings) {
  constexpr NumberRule kFrequency{1, 96'000, "a frequency in Hz, e.g. 1000"};
  if (reader.has("frequency_hz")) {
    level.low_hz = level.high_hz = reader.number("frequency_hz", kFrequency).value_or(1'000);
    if (!reader.has("band_hz")) return;
    findings.error(reader.pointer_to("band_hz"),
                   "it is either noise or a tone",
                   "write \"band_hz\" or \"frequency_hz\"");
  }
  reader.require("band_hz", "[80, 8000] (noise), or \"frequency_hz\" (a tone)");
  const auto edges = reader.items("band_hz", 2, 2);
  if (edges.empty()) return;
  level.low_hz = reader.number_of(*edges[0].first, edges[0].second, kFrequency).value_or(0);
  level.high_hz = reader.number_of(*edges[1].first, edges[1].second, kFrequency).value_or(0);
  if (level.low_hz < level.high_hz || findings.faulty(reader.pointer())) return;
  findings.error(reader.pointer_to("band_hz"),
                 "the lower edge is not below the upper",
                 "write the lower edge first, e.g. [80, 8000]");
}

MeasuredLevel read_level(const Json& value, const std::string& pointer, Findings& findings) {
  ObjectReader reader{value, pointer, findings};
  MeasuredLevel level;
  const TextRule name{.shortest = 1, .longest = 500, .meaning = "a device, as `devices` lists it"};
  reader.require("device", "its name");
  level.device = reader.text("device", name).value_or("");
  reader.require("rate_hz", "48000");
  level.rate_hz = static_cast<int>(
      reader.whole("rate_hz", {8'000, 192'000, "samples per second, e.g. 48000"}).value_or(0));
  read_frequencies(reader, level, findings);
  if (const auto channel = reader.whole("channel", {1, 32, "a channel of the output, from 1"})) {
    level.channel = static_cast<int>(*channel);
  }
  reader.require("dbfs", "-30, the level that was played");
  level.dbfs = Decibels{
      reader.number("dbfs", {-120, 0, "a level in dB re full scale, e.g. -30"}).value_or(0)};
  reader.require("dbspl", "65.2, the level that was measured");
  level.dbspl =
      DecibelsSpl{reader.number("dbspl", {-20, 160, "a level in dB SPL, e.g. 65.2"}).value_or(0)};
  const TextRule about{.longest = 500, .meaning = "a text of one line"};
  level.date = reader.text("date", about).value_or("");
  level.instrument = reader.text("instrument", about).value_or("");
  level.note = reader.text("note", about).value_or("");
  reader.refuse_unknown_keys();
  return level;
}

LevelTable read_table(const Json& json, Findings& findings) {
  ObjectReader reader{json, "", findings};
  std::vector<MeasuredLevel> levels;
  reader.require("bimodal_levels", "1 (the format of this file)");
  static_cast<void>(reader.whole("bimodal_levels", {1, 1, "the format of this file: 1"}));
  reader.require("levels", "a list of measurements; `bimodal levels set` writes them");
  for (const auto& [value, pointer] : reader.items("levels", 0, kMostLevels)) {
    levels.push_back(read_level(*value, pointer, findings));
  }
  reader.refuse_unknown_keys();
  return LevelTable{std::move(levels)};
}

nlohmann::ordered_json as_json(const MeasuredLevel& level) {
  nlohmann::ordered_json json{{"device", level.device}, {"rate_hz", level.rate_hz}};
  if (level.low_hz == level.high_hz) {
    json["frequency_hz"] = level.low_hz;
  } else {
    json["band_hz"] = {level.low_hz, level.high_hz};
  }
  if (level.channel) json["channel"] = *level.channel;
  json["dbfs"] = level.dbfs.count();
  json["dbspl"] = level.dbspl.count();
  json["date"] = level.date;
  json["instrument"] = level.instrument;
  json["note"] = level.note;
  return json;
}

std::optional<std::filesystem::path> folder_named(const char* variable) {
  const char* const value = std::getenv(variable);
  if (value == nullptr || *value == '\0') return std::nullopt;
  return std::filesystem::path{value};
}

std::string text_to_write(const LevelTable& table) {
  try {
    return table.text();
  } catch (const nlohmann::json::exception&) {
    throw Error{"nothing was kept: a text is not UTF-8; write it with plain letters"};
  }
}

}  // namespace

bool same_place(const MeasuredLevel& one, const MeasuredLevel& other) {
  return one.device == other.device && one.rate_hz == other.rate_hz && one.low_hz == other.low_hz &&
         one.high_hz == other.high_hz && one.channel == other.channel;
}

std::optional<MeasuredLevel> LevelTable::put(MeasuredLevel level) {
  const auto found = std::ranges::find_if(
      levels_, [&](const MeasuredLevel& known) { return same_place(known, level); });
  if (found == levels_.end()) {
    levels_.push_back(std::move(level));
    return std::nullopt;
  }
  return std::exchange(*found, std::move(level));
}

std::vector<MeasuredLevel> LevelTable::of(std::string_view device, int rate_hz) const {
  std::vector<MeasuredLevel> found;
  for (const auto& level : levels_) {
    if (level.device == device && level.rate_hz == rate_hz) found.push_back(level);
  }
  return found;
}

std::string LevelTable::text() const {
  nlohmann::ordered_json json{{"bimodal_levels", 1}, {"levels", Json::array()}};
  for (const auto& level : levels_) json["levels"].push_back(as_json(level));
  return json.dump(2) + "\n";
}

std::optional<LevelTable> read_levels_text(std::string_view text,
                                           std::string_view file,
                                           std::vector<Diagnostic>& diagnostics) {
  return read_located(text, file, diagnostics, kMostValues, read_table);
}

std::filesystem::path level_file() {
  if (const auto own = folder_named("BIMODAL_LEVELS")) return *own;
  if (const auto config = folder_named("XDG_CONFIG_HOME")) {
    return *config / "bimodal" / "levels.json";
  }
  if (const auto home = folder_named("HOME")) return *home / ".config" / "bimodal" / "levels.json";
  return "levels.json";
}

LevelTable read_levels(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return {};
  if (const auto reason = obstacle(file)) {
    throw Error{fmt::format("cannot read the measured levels '{}': {}", file.string(), *reason)};
  }
  std::vector<Diagnostic> diagnostics;
  auto table = read_levels_text(read_file(file), file.string(), diagnostics);
  if (table) return std::move(*table);
  std::string all;
  for (const auto& diagnostic : diagnostics) all += "\n  " + describe(diagnostic);
  throw Error{
      fmt::format("the measured levels cannot be used; mend the file or remove it:{}", all)};
}

void write_levels(const std::filesystem::path& file, const LevelTable& table) {
  std::vector<Diagnostic> diagnostics;
  const auto text = text_to_write(table);
  if (!read_levels_text(text, file.string(), diagnostics)) {
    throw Error{fmt::format("nothing was kept: {}", describe(diagnostics.front()))};
  }
  std::error_code ignored;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
  write_file(file, text);
}

}  // namespace bimodal::runner
