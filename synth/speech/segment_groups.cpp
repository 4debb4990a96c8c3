#include "synth/speech/segment_groups.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/json_lines.hpp"

namespace bimodal::synth {

namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 6> kDynamicsColumns{
    "alpha", "theta_before", "theta_after", "offset_ms", "dynamics", "targets"};
/// Any of these may follow, in this order.
constexpr std::array<std::string_view, 3> kFurtherColumns{
    "exponent", "inflection_ms", "theta_early"};
constexpr double kLargestOffsetMs = 500;
constexpr double kLargestExponent = 10;

std::string child(const std::string& pointer, std::string_view key) {
  return pointer + "/" + escape_pointer(key);
}

std::vector<std::string_view> speech_control_names() {
  std::vector<std::string_view> names;
  for (const auto& control : controls().first<kSpeechControlCount>()) names.push_back(control.name);
  return names;
}

}  // namespace

std::size_t SegmentGroups::Columns::count() const {
  return kDynamicsColumns.size() + further.size() + controls.size();
}

void SegmentGroups::read(const json& group, const std::string& pointer) {
  if (!group.is_object()) {
    findings_.error(pointer, "is not an object", "give \"columns\" and \"rows\"");
    return;
  }
  for (const auto& [key, ignored] : group.items()) {
    if (key != "columns" && key != "rows" && key != "form") {
      findings_.error(child(pointer, key), "is not a known key", "known are: columns, rows, form");
    }
  }
  const auto columns = read_columns(group, pointer);
  const auto rows = group.find("rows");
  if (rows == group.end() || !rows->is_object()) {
    findings_.error(pointer,
                    rows == group.end() ? "\"rows\" is missing" : "\"rows\" is not an object",
                    "give an object \"rows\"");
    return;
  }
  if (columns.controls.empty()) return;
  for (const auto& [segments, row] : rows->items()) {
    read_row(segments, row, child(child(pointer, "rows"), segments), columns);
  }
}

DominanceForm SegmentGroups::read_form(const json& group, const std::string& pointer) {
  const auto form = group.find("form");
  if (form == group.end() || *form == "exponential") return DominanceForm::Exponential;
  if (*form == "critically damped") return DominanceForm::CriticallyDamped;
  findings_.error(child(pointer, "form"),
                  form->dump() + " is not a form of dominance",
                  "give \"exponential\" or \"critically damped\", or leave it out");
  return DominanceForm::Exponential;
}

/// Without controls if the columns cannot be used.
SegmentGroups::Columns SegmentGroups::read_columns(const json& group, const std::string& pointer) {
  const auto where = child(pointer, "columns");
  const auto columns = group.find("columns");
  const bool begins_well =
      columns != group.end() && columns->is_array() && columns->size() > kDynamicsColumns.size() &&
      std::equal(kDynamicsColumns.begin(), kDynamicsColumns.end(), columns->begin());
  if (!begins_well) {
    findings_.error(where,
                    "does not name the columns of this format",
                    fmt::format("begin with {}, then {} where they are wanted, and then name the "
                                "controls",
                                fmt::join(kDynamicsColumns, ", "),
                                fmt::join(kFurtherColumns, ", ")));
    return {};
  }
  Columns made{.further = {}, .controls = {}, .form = read_form(group, pointer)};
  std::size_t i = kDynamicsColumns.size();
  for (const auto name : kFurtherColumns) {
    if (i < columns->size() && (*columns)[i] == name) {
      made.further.emplace_back(name);
      ++i;
    }
  }
  const auto first = i;
  for (; i < columns->size(); ++i) {
    const auto& name = (*columns)[i];
    const auto control =
        name.is_string() ? control_from_name(name.get_ref<const std::string&>()) : std::nullopt;
    if (!control || static_cast<std::size_t>(*control) >= kSpeechControlCount) {
      findings_.error(child(where, fmt::to_string(i)),
                      name.dump() + " is not a control that speech sets",
                      fmt::format("known are: {}", fmt::join(speech_control_names(), ", ")));
    } else if (!grouped_.insert(*control).second) {
      findings_.error(child(where, fmt::to_string(i)),
                      name.dump() + " stands in two groups or twice",
                      "keep it in one");
    } else {
      made.controls.push_back(*control);
    }
  }
  if (first + made.controls.size() != columns->size()) made.controls.clear();
  return made;
}

void SegmentGroups::read_row(const std::string& segments,
                             const json& row,
                             const std::string& pointer,
                             const Columns& columns) {
  const auto phones = read_segments(segments, pointer);
  if (!row.is_array() || row.size() != columns.count()) {
    findings_.error(pointer,
                    fmt::format("is not a row of {} values", columns.count()),
                    "give one value for each column");
    return;
  }
  SegmentTarget asked;
  auto& dominance = asked.dominance;
  dominance.form = columns.form;
  dominance.alpha = number(row, 0, pointer);
  dominance.theta_before = number(row, 1, pointer);
  dominance.theta_after = number(row, 2, pointer);
  const double offset_ms = number(row, 3, pointer);
  positive(dominance.alpha, 0, pointer);
  positive(dominance.theta_before, 1, pointer);
  positive(dominance.theta_after, 2, pointer);
  if (std::abs(offset_ms) > kLargestOffsetMs) {
    findings_.error(child(pointer, "3"),
                    fmt::format("an offset of {} ms is beyond any segment", offset_ms),
                    fmt::format("give ms between -{0} and {0}", kLargestOffsetMs));
    return;
  }
  asked.offset = Milliseconds{offset_ms};
  asked.dynamics_source = source(row, 4, pointer);
  asked.target_source = source(row, 5, pointer);
  read_further(row, pointer, columns, dominance);
  const auto first = columns.count() - columns.controls.size();
  for (std::size_t i = 0; i < columns.controls.size(); ++i) {
    asked.target = number(row, first + i, pointer);
    for (const Phone phone : phones) set(phone, columns.controls[i], asked, pointer);
  }
}

/// Exponent, and where theta changes; null stands for "it does not".
void SegmentGroups::read_further(const json& row,
                                 const std::string& pointer,
                                 const Columns& columns,
                                 Dominance& dominance) {
  bool has_distance = false;
  bool has_theta = false;
  for (std::size_t i = 0; i < columns.further.size(); ++i) {
    const auto column = kDynamicsColumns.size() + i;
    if (columns.further[i] == "exponent") {
      dominance.exponent = number(row, column, pointer);
      if (dominance.exponent <= 0 || dominance.exponent > kLargestExponent) {
        findings_.error(child(pointer, fmt::to_string(column)),
                        fmt::format("an exponent of {} is beyond use", dominance.exponent),
                        fmt::format("give a number above 0, at most {}", kLargestExponent));
      }
    } else if (!row[column].is_null()) {
      const double value = number(row, column, pointer);
      positive(value, column, pointer);
      const bool is_distance = columns.further[i] == "inflection_ms";
      (is_distance ? dominance.inflection_ms : dominance.theta_early) = value;
      (is_distance ? has_distance : has_theta) = true;
    }
  }
  if (has_distance != has_theta) {
    findings_.error(pointer,
                    "inflection_ms and theta_early do not stand together",
                    "give both columns, and null in both for segments whose theta does not change");
  } else if (has_distance && dominance.exponent != 1) {
    findings_.error(pointer,
                    "a dominance that changes its rate has another exponent than 1",
                    "give exponent 1, or null for inflection_ms and theta_early");
  }
}

std::vector<Phone> SegmentGroups::read_segments(const std::string& segments,
                                                const std::string& pointer) {
  std::vector<Phone> phones;
  std::istringstream words{segments};
  for (std::string word; words >> word;) {
    const auto phone = phone_from_symbol(word);
    if (!phone || symbol(*phone) != word) {
      findings_.error(pointer,
                      fmt::format("\"{}\" is not a segment", word),
                      "write segments as P, IY, rest, parted by spaces");
    } else if (face_segments(*phone).size() != 1) {
      findings_.error(pointer,
                      fmt::format("\"{}\" is two segments for the face", word),
                      fmt::format("give {} instead", spell(face_segments(*phone))));
    } else {
      phones.push_back(*phone);
    }
  }
  if (segments.find_first_not_of(' ') == std::string::npos) {
    findings_.error(pointer, "names no segment", "write segments as P, IY, rest, parted by spaces");
  }
  return phones;
}

/// NaN, with the mistake noted, if it is not a finite number.
double SegmentGroups::number(const json& row, std::size_t column, const std::string& pointer) {
  if (row[column].is_number() && std::isfinite(row[column].get<double>())) return row[column];
  findings_.error(child(pointer, fmt::to_string(column)),
                  row[column].dump() + " is not a number",
                  "give a number in the column's unit");
  return std::nan("");
}

void SegmentGroups::positive(double number, std::size_t column, const std::string& pointer) {
  if (number > 0 || std::isnan(number)) return;
  findings_.error(child(pointer, fmt::to_string(column)),
                  fmt::format("{} is not above 0", number),
                  "give a positive number");
}

std::string SegmentGroups::source(const json& row, std::size_t column, const std::string& pointer) {
  const auto& key = row[column];
  if (key.is_string() && sources_.contains(key.get_ref<const std::string&>())) {
    used_sources_.insert(key.get<std::string>());
    return key;
  }
  findings_.error(child(pointer, fmt::to_string(column)),
                  key.dump() + " is not a source",
                  "give a key of /sources, and say there where the values come from");
  return {};
}

void SegmentGroups::set(Phone phone,
                        Control control,
                        const SegmentTarget& asked,
                        const std::string& pointer) {
  if (!set_.insert({phone, control}).second) {
    findings_.error(pointer,
                    fmt::format("{} has {} set already", symbol(phone), describe(control).name),
                    "keep one row for each segment in a group");
    return;
  }
  targets_.at(static_cast<std::size_t>(phone)).at(static_cast<std::size_t>(control)) = asked;
}

}  // namespace bimodal::synth
