#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "stimuli/base/json_lines.hpp"
#include "stimuli/base/json_text.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::synth {

namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 6> kDynamicsColumns{
    "alpha", "theta_before", "theta_after", "offset_ms", "dynamics", "targets"};
constexpr double kLargestOffsetMs = 500;

std::string child(const std::string& pointer, std::string_view key) {
  return pointer + "/" + escape_pointer(key);
}

std::string joined(std::span<const std::string_view> words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

/// Reads one file. Every step notes what is wrong and goes on with what remains.
class SegmentTableReader {
 public:
  SegmentTableReader(std::string_view file, std::vector<Diagnostic>& diagnostics)
      : file_{file}, diagnostics_{diagnostics} {}

  std::optional<SegmentTable> read(std::string_view text) {
    const auto root = syntax_tree(text);
    if (!failed_) root_of(root);
    if (!failed_) everything_set();
    if (failed_) return std::nullopt;
    return std::move(table_);
  }

 private:
  struct Row {
    std::string pointer;
    std::vector<Phone> segments;
    SegmentTarget dynamics;  ///< without target
  };

  void add(Severity severity, std::string pointer, std::string finding, std::string remedy) {
    failed_ = failed_ || severity == Severity::Error;
    diagnostics_.push_back({.severity = severity,
                            .file = file_,
                            .line = lines_ ? lines_->line_of(pointer) : 0,
                            .pointer = std::move(pointer),
                            .finding = std::move(finding),
                            .remedy = std::move(remedy)});
  }

  void error(std::string pointer, std::string finding, std::string remedy) {
    add(Severity::Error, std::move(pointer), std::move(finding), std::move(remedy));
  }

  /// The JSON, with keys that stand twice noted (the library would silently keep the last).
  json syntax_tree(std::string_view text) {
    auto parsed = parse_json(text);
    if (const auto* fault = std::get_if<TextFault>(&parsed)) {
      error("", fault->finding, fault->remedy);
      diagnostics_.back().line = fault->line;
      return {};
    }
    lines_.emplace(text);
    for (const auto& doubled : lines_->duplicates()) {
      error(
          doubled.pointer,
          fmt::format("the key stands twice in one object, first on line {}", doubled.earlier_line),
          "keep one of them");
    }
    return std::get<json>(std::move(parsed));
  }

  const json* object_in(const json& parent, const std::string& pointer, const char* key) {
    const auto found = parent.find(key);
    if (found != parent.end() && found->is_object()) return &*found;
    error(pointer,
          found == parent.end() ? fmt::format("\"{}\" is missing", key)
                                : fmt::format("\"{}\" is not an object", key),
          fmt::format("give an object \"{}\"", key));
    return nullptr;
  }

  void only_keys(const json& object,
                 const std::string& pointer,
                 std::span<const std::string_view> known) {
    for (const auto& [key, ignored] : object.items()) {
      if (std::ranges::find(known, key) == known.end()) {
        error(child(pointer, key), "is not a known key", "known are: " + joined(known));
      }
    }
  }

  void root_of(const json& root) {
    if (!root.is_object()) {
      error("", "is not an object", "give {\"sources\": ..., \"groups\": ...}");
      return;
    }
    constexpr std::array<std::string_view, 3> kKeys{"about", "sources", "groups"};
    only_keys(root, "", kKeys);
    if (const auto* sources = object_in(root, "", "sources")) read_sources(*sources);
    if (const auto* groups = object_in(root, "", "groups")) {
      for (const auto& [name, group] : groups->items()) read_group(group, child("/groups", name));
    }
    for (const auto& [key, ignored] : table_.sources_) {
      if (!used_sources_.contains(key)) {
        add(Severity::Warning, child("/sources", key), "no row uses this source", "remove it");
      }
    }
  }

  void read_sources(const json& sources) {
    for (const auto& [key, reference] : sources.items()) {
      if (reference.is_string() && !reference.get_ref<const std::string&>().empty()) {
        table_.sources_[key] = reference;
      } else {
        error(child("/sources", key),
              reference.dump() + " is not a reference",
              "say in words where the values come from");
      }
    }
  }

  void read_group(const json& group, const std::string& pointer) {
    if (!group.is_object()) {
      error(pointer, "is not an object", "give \"columns\" and \"rows\"");
      return;
    }
    constexpr std::array<std::string_view, 2> kKeys{"columns", "rows"};
    only_keys(group, pointer, kKeys);
    const auto controls = read_columns(group, pointer);
    const auto* rows = object_in(group, pointer, "rows");
    if (rows == nullptr || controls.empty()) return;
    for (const auto& [segments, row] : rows->items()) {
      read_row(segments, row, child(child(pointer, "rows"), segments), controls);
    }
  }

  /// The controls of a group; empty if the columns cannot be used.
  std::vector<Control> read_columns(const json& group, const std::string& pointer) {
    const auto where = child(pointer, "columns");
    const auto columns = group.find("columns");
    const bool begins_well =
        columns != group.end() && columns->is_array() &&
        columns->size() > kDynamicsColumns.size() &&
        std::equal(kDynamicsColumns.begin(), kDynamicsColumns.end(), columns->begin());
    if (!begins_well) {
      error(where,
            "does not name the columns of this format",
            fmt::format("begin with {}, and then name the controls", joined(kDynamicsColumns)));
      return {};
    }
    std::vector<Control> controls;
    for (std::size_t i = kDynamicsColumns.size(); i < columns->size(); ++i) {
      const auto& name = (*columns)[i];
      const auto control =
          name.is_string() ? control_from_name(name.get_ref<const std::string&>()) : std::nullopt;
      if (!control || static_cast<std::size_t>(*control) >= kSpeechControlCount) {
        error(child(where, fmt::to_string(i)),
              name.dump() + " is not a control that speech sets",
              "known are: " + joined(speech_control_names()));
      } else if (!grouped_.insert(*control).second) {
        error(child(where, fmt::to_string(i)),
              name.dump() + " stands in two groups or twice",
              "keep it in one");
      } else {
        controls.push_back(*control);
      }
    }
    const bool all_known = controls.size() + kDynamicsColumns.size() == columns->size();
    return all_known ? controls : std::vector<Control>{};
  }

  static std::vector<std::string_view> speech_control_names() {
    std::vector<std::string_view> names;
    for (const auto& control : controls().first<kSpeechControlCount>())
      names.push_back(control.name);
    return names;
  }

  void read_row(const std::string& segments,
                const json& row,
                const std::string& pointer,
                const std::vector<Control>& controls) {
    const auto phones = read_segments(segments, pointer);
    if (!row.is_array() || row.size() != kDynamicsColumns.size() + controls.size()) {
      error(pointer,
            fmt::format("is not a row of {} values", kDynamicsColumns.size() + controls.size()),
            "give one value for each column");
      return;
    }
    SegmentTarget asked;
    auto& dominance = asked.dominance;
    dominance.alpha = number(row, 0, pointer);
    dominance.theta_before = number(row, 1, pointer);
    dominance.theta_after = number(row, 2, pointer);
    const double offset_ms = number(row, 3, pointer);
    positive(dominance.alpha, 0, pointer);
    positive(dominance.theta_before, 1, pointer);
    positive(dominance.theta_after, 2, pointer);
    if (std::abs(offset_ms) > kLargestOffsetMs) {
      error(child(pointer, "3"),
            fmt::format("an offset of {} ms is beyond any segment", offset_ms),
            fmt::format("give ms between -{0} and {0}", kLargestOffsetMs));
      return;
    }
    asked.offset = Milliseconds{offset_ms};
    asked.dynamics_source = source(row, 4, pointer);
    asked.target_source = source(row, 5, pointer);
    for (std::size_t i = 0; i < controls.size(); ++i) {
      asked.target = number(row, kDynamicsColumns.size() + i, pointer);
      for (const Phone phone : phones) set(phone, controls[i], asked, pointer);
    }
  }

  std::vector<Phone> read_segments(const std::string& segments, const std::string& pointer) {
    std::vector<Phone> phones;
    std::istringstream words{segments};
    for (std::string word; words >> word;) {
      const auto phone = phone_from_symbol(word);
      if (!phone || symbol(*phone) != word) {
        error(pointer,
              fmt::format("\"{}\" is not a segment", word),
              "write segments as P, IY, rest, parted by spaces");
      } else if (face_segments(*phone).size() != 1) {
        error(pointer,
              fmt::format("\"{}\" is two segments for the face", word),
              fmt::format("give {} instead", spell(face_segments(*phone))));
      } else {
        phones.push_back(*phone);
      }
    }
    if (segments.find_first_not_of(' ') == std::string::npos) {
      error(pointer, "names no segment", "write segments as P, IY, rest, parted by spaces");
    }
    return phones;
  }

  /// NaN, with the mistake noted, if it is not a finite number.
  double number(const json& row, std::size_t column, const std::string& pointer) {
    if (row[column].is_number() && std::isfinite(row[column].get<double>())) return row[column];
    error(child(pointer, fmt::to_string(column)),
          row[column].dump() + " is not a number",
          "give a number in the column's unit");
    return std::nan("");
  }

  void positive(double number, std::size_t column, const std::string& pointer) {
    if (number > 0 || std::isnan(number)) return;
    error(child(pointer, fmt::to_string(column)),
          fmt::format("{} {} is not above 0", kDynamicsColumns.at(column), number),
          "give a positive number");
  }

  std::string source(const json& row, std::size_t column, const std::string& pointer) {
    const auto& key = row[column];
    if (key.is_string() && table_.sources_.contains(key)) {
      used_sources_.insert(key);
      return key;
    }
    error(child(pointer, fmt::to_string(column)),
          key.dump() + " is not a source",
          "give a key of /sources, and say there where the values come from");
    return {};
  }

  void set(Phone phone, Control control, const SegmentTarget& asked, const std::string& pointer) {
    if (!set_.insert({phone, control}).second) {
      error(pointer,
            fmt::format("{} has {} set already", symbol(phone), describe(control).name),
            "keep one row for each segment in a group");
      return;
    }
    table_.targets_.at(static_cast<std::size_t>(phone)).at(static_cast<std::size_t>(control)) =
        asked;
  }

  /// Nothing unknown becomes zero: each segment sets each speech control.
  void everything_set() {
    for (const auto& control : controls().first<kSpeechControlCount>()) {
      std::vector<std::string_view> missing;
      for (const Phone phone : all_phones().first(kFaceSegmentCount)) {
        if (!set_.contains({phone, control.control})) missing.push_back(symbol(phone));
      }
      if (missing.size() == kFaceSegmentCount) {
        error("/groups",
              fmt::format("no group has the control {}", control.name),
              "add it to a group's columns and rows");
      } else if (!missing.empty()) {
        error("/groups",
              fmt::format("{} is not set for {}", control.name, joined(missing)),
              "add rows for these segments");
      }
    }
  }

  std::string file_;
  std::vector<Diagnostic>& diagnostics_;
  std::optional<JsonLines> lines_;  ///< once it has been parsed
  SegmentTable table_;
  std::set<std::string> used_sources_;
  std::set<Control> grouped_;
  std::set<std::pair<Phone, Control>> set_;
  bool failed_ = false;
};

std::optional<SegmentTable> SegmentTable::parse(std::string_view text,
                                                std::string_view file,
                                                std::vector<Diagnostic>& diagnostics) {
  return SegmentTableReader{file, diagnostics}.read(text);
}

}  // namespace bimodal::synth
