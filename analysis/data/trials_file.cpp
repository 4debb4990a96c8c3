#include "analysis/data/trials_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/base/csv_reader.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/lower_case.hpp"
#include "stimuli/base/nearest.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal::analysis {

namespace {

constexpr std::string_view kForm =
    "begin with a line like participant,trial,condition,stimulus,response, or name the columns in "
    "a mapping file (--mapping)";

/// Other names under which a field is found where nobody maps it.
struct Alias {
  std::string_view field;
  std::string_view column;
};

constexpr std::array kAliases = std::to_array<Alias>({{"participant", "participant_id"},
                                                      {"participant", "subject"},
                                                      {"participant", "subject_id"},
                                                      {"stimulus", "word"},
                                                      {"response_ms", "submitted_ms"},
                                                      {"response_ms", "rt_ms"}});

using Header = std::vector<std::string>;

std::optional<std::size_t> place_in(const Header& header, std::string_view column) {
  const auto found = std::ranges::find(header, column);
  if (found == header.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header.begin());
}

/// The same; where no column is spelt so, one that is but for capitals.
std::optional<std::size_t> place_whatever_case(const Header& header, std::string_view column) {
  if (const auto place = place_in(header, column)) return place;
  const auto found = std::ranges::find_if(
      header, [&](const std::string& name) { return lower_case(name) == column; });
  if (found == header.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header.begin());
}

/// Under the field's own name, or one that means the same.
std::optional<std::size_t> place_unmapped(const Header& header, std::string_view field) {
  if (const auto place = place_whatever_case(header, field)) return place;
  for (const auto& alias : kAliases) {
    if (alias.field != field) continue;
    if (const auto place = place_whatever_case(header, alias.column)) return place;
  }
  return std::nullopt;
}

class TrialReader {
 public:
  TrialReader(std::string_view text, std::string_view file, const TrialMapping& mapping)
      : csv_{text, file, mapping.delimiter}, mapping_{mapping} {
    if (!is_utf8(text)) csv_.refuse("the file is not UTF-8 text", "save it as CSV, UTF-8");
  }

  TrialsOfFile read() {
    auto header = csv_.next();
    if (!header) csv_.refuse("the file is empty", kForm);
    header_ = std::move(*header);
    find_columns();
    while (auto fields = csv_.next()) add(std::move(*fields));
    if (file_.sessions.empty()) csv_.refuse("there are no trials after the first line", kForm);
    for (auto& session : file_.sessions) summarise(session);
    return std::move(file_);
  }

 private:
  void find_columns() {
    for (const auto field : kTrialFields) {
      auto& places = places_[field];
      const auto mapped = mapping_.columns.find(std::string{field});
      if (mapped == mapping_.columns.end()) {
        if (const auto place = place_unmapped(header_, field)) places.push_back(*place);
        continue;
      }
      for (const auto& column : mapped->second) {
        const auto place = place_in(header_, column);
        if (!place) {
          csv_.refuse(
              fmt::format(
                  "there is no column \"{}\", of which the mapping makes \"{}\"", column, field),
              fmt::format("the columns are: {}", fmt::join(header_, ", ")));
        }
        places.push_back(*place);
      }
    }
    for (const std::string_view needed : {"stimulus", "response"}) {
      if (!places_[needed].empty() || mapping_.constants.contains(std::string{needed})) continue;
      csv_.refuse(fmt::format("there is no column \"{}\"", needed), kForm);
    }
    if (places_["participant"].empty() && !mapping_.constants.contains("participant")) {
      file_.warnings.emplace_back(
          "The table of trials names no participants: all trials are taken for one participant's.");
    }
    warn_of_unread_columns();
  }

  [[nodiscard]] bool is_absent(std::string_view field) const {
    return places_.at(field).empty() && !mapping_.constants.contains(std::string{field});
  }

  [[nodiscard]] bool is_read(std::size_t column) const {
    return std::ranges::any_of(places_, [&](const auto& field) {
      return std::ranges::find(field.second, column) != field.second.end();
    });
  }

  /// A misspelt name is not to put all conditions together, or to forget who was left out.
  void warn_of_unread_columns() {
    std::vector<std::string_view> absent;
    std::ranges::copy_if(
        kTrialFields, std::back_inserter(absent), [&](auto field) { return is_absent(field); });
    std::vector<std::string> unread;
    for (std::size_t i = 0; i < header_.size(); ++i) {
      if (is_read(i)) continue;
      unread.push_back(fmt::format("\"{}\"", header_[i]));
      const auto meant = nearest(header_[i], absent);
      if (!meant) continue;
      file_.warnings.push_back(
          fmt::format("The column \"{}\" of the table of trials is not read; if it is meant to be "
                      "\"{}\", name it so, or in a mapping file (--mapping).",
                      header_[i],
                      *meant));
    }
    if (!is_absent("condition") || unread.empty()) return;
    file_.warnings.push_back(
        fmt::format("The table of trials names no conditions: all trials are taken for one "
                    "condition, \"all\". Columns that are not read: {}.",
                    fmt::join(unread, ", ")));
  }

  /// The text of a field; nothing where there is no such column.
  [[nodiscard]] std::optional<std::string> text(std::string_view field) const {
    std::optional<std::string> found;
    const auto& places = places_.at(field);
    for (const auto place : places) {
      found = found ? *found + " " + fields_[place] : fields_[place];
    }
    const std::string key{field};
    if (!found) {
      const auto constant = mapping_.constants.find(key);
      if (constant == mapping_.constants.end()) return std::nullopt;
      found = constant->second;
    }
    const auto replaced = mapping_.values.find(key);
    if (replaced == mapping_.values.end()) return found;
    const auto value = replaced->second.find(*found);
    return value == replaced->second.end() ? found : value->second;
  }

  [[nodiscard]] std::optional<std::string> name(std::string_view field) const {
    auto found = text(field);
    return found && found->empty() ? std::nullopt : found;
  }

  [[nodiscard]] std::optional<double> number(std::string_view field) const {
    const auto found = text(field);
    if (!found || found->empty() || *found == "NA") return std::nullopt;
    double value = 0.0;
    const auto* const end = found->data() + found->size();
    const auto [reached, fault] = std::from_chars(found->data(), end, value);
    if (fault != std::errc{} || reached != end || !std::isfinite(value) || std::abs(value) > 1e9) {
      csv_.refuse(fmt::format("\"{}\", the {}, is no number", *found, field),
                  "write a number with a decimal point, or nothing where there is none");
    }
    return value;
  }

  [[nodiscard]] int whole(std::string_view field, int otherwise) const {
    const auto value = number(field);
    if (!value) return otherwise;
    if (std::trunc(*value) != *value) {
      csv_.refuse(fmt::format("{}, the {}, is no whole number", *value, field),
                  "count from 0 or 1");
    }
    return static_cast<int>(*value);
  }

  [[nodiscard]] bool flag(std::string_view field) const {
    const auto found = text(field);
    const auto value = lower_case(found.value_or(""));
    for (const std::string_view yes : {"1", "true", "yes", "t", "y"}) {
      if (value == yes) return true;
    }
    for (const std::string_view no : {"", "0", "false", "no", "f", "n", "na"}) {
      if (value == no) return false;
    }
    csv_.refuse(fmt::format("\"{}\", of \"{}\", says neither yes nor no", *found, field),
                "write 1 or 0, true or false");
  }

  [[nodiscard]] std::optional<Duration> milliseconds(std::string_view field) const {
    const auto value = number(field);
    if (!value) return std::nullopt;
    return Duration{std::llround(*value * 1e6)};
  }

  [[nodiscard]] Pronunciation phones() const {
    Pronunciation read;
    std::istringstream symbols{text("phones").value_or("")};
    for (std::string written; symbols >> written;) {
      const auto phone = phone_from_symbol(written);
      if (!phone || *phone == Phone::Rest) {
        csv_.refuse(fmt::format("\"{}\" among the phones is no phone", written),
                    "write ARPAbet with blanks between, like S T UW");
      }
      read.push_back(*phone);
    }
    return read;
  }

  void add(std::vector<std::string> fields) {
    if (fields.size() != header_.size()) {
      csv_.refuse(
          fmt::format("{} fields, but the first line has {}", fields.size(), header_.size()),
          "write one for each column, nothing between two delimiters where there is none");
    }
    fields_ = std::move(fields);
    auto stimulus = name("stimulus");
    if (!stimulus) csv_.refuse("the trial has no stimulus", "name what was presented");
    const auto participant = text("participant").value_or("1");
    if (participant.empty()) {
      csv_.refuse("the trial has no participant",
                  "name who answered; a table of one participant may leave out the column");
    }
    const auto session = whole("session", 1);
    auto& trials = session_of(participant, session).trials;
    trials.push_back({.session = 0,
                      .participant = participant,
                      .trial = whole("trial", static_cast<int>(trials.size())),
                      .phase = name("phase").value_or("main"),
                      .block = whole("block", 0),
                      .condition = name("condition").value_or("all"),
                      .auditory_talker = name("auditory_talker"),
                      .visual_talker = name("visual_talker"),
                      .snr_db = number("snr_db"),
                      .word = std::move(*stimulus),
                      .visual_word = name("visual_word"),
                      .articulation = name("articulation"),
                      .face = std::nullopt,
                      .phones = phones(),
                      .response = text("response").value_or(""),
                      .first_key = milliseconds("first_key_ms"),
                      .submitted = milliseconds("response_ms"),
                      .timed_out = flag("timed_out"),
                      .flagged = flag("flagged"),
                      .timing_known = !text("flagged").value_or("").empty(),
                      .excluded = flag("excluded"),
                      .simulated = flag("simulated")});
  }

  SessionTrials& session_of(const std::string& participant, int session) {
    const auto [found, is_new] =
        session_places_.try_emplace({participant, session}, file_.sessions.size());
    if (is_new) {
      const auto number = static_cast<int>(
          participants_.try_emplace(participant, participants_.size() + 1).first->second);
      file_.sessions.push_back({.summary = {.id = static_cast<std::int64_t>(found->second) + 1,
                                            .participant = participant,
                                            .participant_number = number,
                                            .session_number = session,
                                            .outcome = "complete"},
                                .trials = {}});
    }
    return file_.sessions[found->second];
  }

  static void summarise(SessionTrials& session) {
    auto& summary = session.summary;
    summary.stored_trials = static_cast<int>(session.trials.size());
    summary.planned_trials = summary.stored_trials;
    summary.simulated = std::ranges::any_of(session.trials, &Trial::simulated);
    if (!std::ranges::any_of(session.trials, &Trial::timing_known)) return;
    summary.flagged_trials =
        static_cast<int>(std::ranges::count_if(session.trials, &Trial::flagged));
  }

  CsvReader csv_;
  const TrialMapping& mapping_;
  Header header_;
  std::map<std::string_view, std::vector<std::size_t>> places_;  ///< of a field, its columns
  std::vector<std::string> fields_;                              ///< of the line being read
  std::map<std::pair<std::string, int>, std::size_t> session_places_;
  std::map<std::string, std::size_t> participants_;  ///< numbers, from 1
  TrialsOfFile file_;
};

}  // namespace

bool is_trial_table(std::string_view text) {
  try {
    const auto header = CsvReader{text, ""}.next();
    return header && place_unmapped(*header, "stimulus") && place_unmapped(*header, "response") &&
           !place_whatever_case(*header, "count") &&  // of a confusion matrix, as a list
           (place_unmapped(*header, "participant") || place_unmapped(*header, "condition") ||
            place_unmapped(*header, "trial") || header->size() == 2);
  } catch (const Error&) {
    return false;
  }
}

TrialsOfFile parse_trials(std::string_view text,
                          std::string_view file,
                          const TrialMapping& mapping) {
  return TrialReader{text, file, mapping}.read();
}

TrialsOfFile read_trials(const std::filesystem::path& file, const TrialMapping& mapping) {
  const auto text = read_file(file);
  auto read = parse_trials(text, file.string(), mapping);
  read.file = {file.string(), sha256(text)};
  return read;
}

}  // namespace bimodal::analysis
