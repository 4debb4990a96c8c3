#include "synth/fitting/track_file.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/obstacle.hpp"
#include "stimuli/labels/label_lines.hpp"

namespace bimodal::synth {

namespace {

constexpr std::size_t kMostMessages = 20;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const auto comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

std::optional<double> number(std::string_view field) {
  double value = 0;
  const auto* const end = field.data() + field.size();
  const auto [stopped, fault] = std::from_chars(field.data(), end, value);
  if (fault != std::errc{} || stopped != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// A column of the file that is wanted, and where in a line it stands.
struct Place {
  std::string name;
  std::size_t field = 0;
};

class TrackReader {
 public:
  TrackReader(std::string_view text, const std::string& name, const TrackRequest& request)
      : lines_{text}, name_{name}, request_{request} {
    track_.file = name;
  }

  Track read() {
    const auto header = next_line();
    if (!header)
      fail("the file is empty",
           "begin with the names of columns, e.g. time_ms,inner_h,outer_w (measures) or "
           "time_ms,jaw (controls)");
    names_ = fields_of(*header);
    line_ = lines_.number();
    const auto first = next_line();
    if (!first) fail("there is no line below the names", "give a line for each instant");
    place_time();
    place_columns(fields_of(*first));
    end_if_faulty();
    for (auto line = first; line; line = next_line()) {
      line_ = lines_.number();
      add(fields_of(*line));
    }
    if (track_.time_ms.size() < 2) complain("there is one instant only", "give a line for each");
    end_if_faulty();
    return std::move(track_);
  }

 private:
  /// Without the blank lines.
  std::optional<std::string_view> next_line() {
    auto line = lines_.next();
    while (line && trimmed(*line).empty()) line = lines_.next();
    return line;
  }

  void complain(std::string_view finding, std::string_view remedy) {
    ++complaints_;
    if (complaints_ > kMostMessages) return;
    if (!messages_.empty()) messages_ += '\n';
    messages_ += fmt::format("{}:{}: {}; {}", name_, line_, finding, remedy);
  }

  void end_if_faulty() const {
    if (complaints_ == 0) return;
    const auto more = complaints_ - std::min(complaints_, kMostMessages);
    throw Error{more == 0 ? messages_ : fmt::format("{}\n... and {} more", messages_, more)};
  }

  [[noreturn]] void fail(std::string_view finding, std::string_view remedy) {
    throw Error{fmt::format("{}: {}; {}", name_, finding, remedy)};
  }

  [[nodiscard]] std::optional<std::size_t> field_named(std::string_view name) const {
    const auto found = std::ranges::find(names_, name);
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
  }

  [[nodiscard]] std::string known() const {
    return fmt::format("the first line has {}", fmt::join(names_, ", "));
  }

  void place_time() {
    const auto& wanted = request_.time_column;
    for (const std::string_view name : {"time_ms", "time_s"}) {
      if (time_ || !wanted.empty()) break;
      time_ = field_named(name);
    }
    if (!wanted.empty()) time_ = field_named(wanted);
    if (!time_) {
      complain(wanted.empty() ? "there is no column time_ms or time_s"
                              : fmt::format("there is no column \"{}\"", wanted),
               known() + "; name the column of times by --time-column");
      return;
    }
    const auto name = names_[*time_];
    if (name.ends_with("_ms")) {
      ms_per_unit_ = 1;
    } else if (name.ends_with("_s")) {
      ms_per_unit_ = 1e3;
    } else {
      complain(fmt::format("the name of the time column \"{}\" tells no unit", name),
               "let it end in _ms or _s");
    }
  }

  [[nodiscard]] bool is_measure(std::size_t field, std::string_view value) const {
    const auto name = names_[field];
    return field != time_ && name != "frame" && name != "time_ms" && name != "time_s" &&
           !name.ends_with("_sm") && !name.starts_with("head_") && number(value).has_value();
  }

  void place_columns(const std::vector<std::string_view>& first) {
    for (const auto& name : request_.columns) {
      const auto field = field_named(name);
      if (std::ranges::find(places_, name, &Place::name) != places_.end()) {
        complain(fmt::format("the column \"{}\" is asked for twice", name), "name it once");
      } else if (field) {
        places_.push_back({.name = name, .field = *field});
      } else {
        complain(fmt::format("there is no column \"{}\"", name), known());
      }
    }
    if (request_.columns.empty()) {
      for (std::size_t i = 0; i < std::min(names_.size(), first.size()); ++i) {
        if (is_measure(i, first[i])) {
          places_.push_back({.name = std::string{names_[i]}, .field = i});
        }
      }
      if (places_.empty()) complain("there is no column of numbers beside the time", known());
    }
    for (const auto& place : places_) track_.columns.push_back({.name = place.name, .values = {}});
  }

  void add(const std::vector<std::string_view>& fields) {
    if (fields.size() != names_.size()) {
      complain(fmt::format("{} fields, but the first line has {}", fields.size(), names_.size()),
               "write one for each column, without quotation marks");
      return;
    }
    const auto time = number(fields[*time_]);
    if (!time) {
      complain(fmt::format("the time {} is no number", in_quotes(fields[*time_])),
               "give every line its time");
    } else if (!track_.time_ms.empty() && *time * ms_per_unit_ <= track_.time_ms.back()) {
      complain(fmt::format("the time {} does not come after the one before it", fields[*time_]),
               "put the lines in order of time, each instant once");
    } else {
      track_.time_ms.push_back(*time * ms_per_unit_);
    }
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto field = fields[places_[i].field];
      const auto value = number(field);
      if (!value) {
        complain(fmt::format("{} {} is no finite number", places_[i].name, in_quotes(field)),
                 "leave out the lines of instants that were not measured");
      }
      track_.columns[i].values.push_back(value.value_or(0));
    }
  }

  LineReader lines_;
  std::size_t line_ = 1;  ///< that is being judged
  std::string name_;
  const TrackRequest& request_;
  std::vector<std::string_view> names_;
  std::optional<std::size_t> time_;
  double ms_per_unit_ = 1;
  std::vector<Place> places_;
  Track track_;
  std::size_t complaints_ = 0;
  std::string messages_;
};

}  // namespace

const TrackColumn* Track::column(std::string_view name) const {
  const auto found = std::ranges::find(columns, name, &TrackColumn::name);
  return found == columns.end() ? nullptr : &*found;
}

Track read_track(const std::filesystem::path& file, const TrackRequest& request) {
  if (const auto why = obstacle(file)) throw Error{fmt::format("{}: {}", file.string(), *why)};
  return parse_track(read_file(file), file.string(), request);
}

Track parse_track(std::string_view text, const std::string& name, const TrackRequest& request) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return TrackReader{text, name, request}.read();
}

double interpolated(const Track& track, const TrackColumn& column, double time_ms) {
  const auto& times = track.time_ms;
  assert(time_ms >= times.front() && time_ms <= times.back());
  const auto after = std::ranges::upper_bound(times, time_ms);
  if (after == times.end()) return column.values.back();
  const auto i = static_cast<std::size_t>(after - times.begin());
  const double share = (time_ms - times[i - 1]) / (times[i] - times[i - 1]);
  return std::lerp(column.values[i - 1], column.values[i], share);
}

}  // namespace bimodal::synth
