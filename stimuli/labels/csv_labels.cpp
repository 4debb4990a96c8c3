#include "stimuli/labels/csv_labels.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "stimuli/base/csv.hpp"
#include "stimuli/labels/label_time.hpp"
#include "stimuli/labels/tier_builder.hpp"

namespace bimodal {

namespace {

constexpr std::size_t kMostFields = 1'000;  ///< of one record

/// Takes records off a text, field by field (RFC 4180, section 2).
class CsvReader {
 public:
  CsvReader(std::string_view text, std::string_view file) : text_{text}, file_{file} {}

  /// The fields of the next line that is not empty; absent after the last one.
  std::optional<std::vector<std::string>> next() {
    while (at_ < text_.size() && text_[at_] == '\n') step();
    line_ = reached_line_;
    if (at_ >= text_.size()) return std::nullopt;
    std::vector<std::string> fields;
    while (true) {
      if (fields.size() == kMostFields) {
        refuse(line(), fmt::format("more than {} fields", kMostFields), "is this the right file?");
      }
      fields.push_back(take_field());
      if (at_ == text_.size()) return fields;
      const bool goes_on = text_[at_] == ',';
      step();
      if (!goes_on) return fields;
    }
  }

  /// Where the record begins that `next` gave last.
  [[nodiscard]] LabelLine line() const { return {file_, line_}; }

 private:
  void step() {
    if (text_[at_] == '\n') ++reached_line_;
    ++at_;
  }

  std::string take_field() {
    if (at_ < text_.size() && text_[at_] == '"') return take_quoted_field();
    const auto field = text_.substr(at_, text_.find_first_of(",\n", at_) - at_);
    if (field.find('"') != std::string_view::npos) {
      refuse({file_, reached_line_},
             fmt::format("a quotation mark within {}", field),
             "put the whole field in quotation marks, and two where one is meant");
    }
    at_ += field.size();
    return std::string{field};
  }

  std::string take_quoted_field() {
    const LabelLine begin{file_, reached_line_};
    std::string field;
    ++at_;
    while (at_ < text_.size()) {
      const bool quote = text_[at_] == '"';
      if (quote && (at_ + 1 == text_.size() || text_[at_ + 1] != '"')) {
        ++at_;
        if (at_ < text_.size() && text_[at_] != ',' && text_[at_] != '\n') {
          refuse({file_, reached_line_},
                 fmt::format("{} goes on behind its quotation mark", in_quotes(field)),
                 "write \"\" for a quotation mark within a field");
        }
        return field;
      }
      field += text_[at_];
      if (quote) ++at_;
      step();
    }
    refuse(
        begin, "the quoted field that begins here does not end", "close it with a quotation mark");
  }

  std::string_view text_;
  std::string_view file_;
  std::size_t at_ = 0;
  std::size_t reached_line_ = 1;
  std::size_t line_ = 1;
};

struct Columns {
  std::size_t start = 0;
  std::size_t end = 0;
  std::size_t text = 0;
  std::optional<std::size_t> tier;
  std::size_t count = 0;
};

Columns columns_of(const std::vector<std::string>& header, const LabelLine& line) {
  const auto find = [&](std::string_view name) -> std::optional<std::size_t> {
    const auto found =
        std::ranges::find_if(header, [&](const auto& field) { return trimmed(field) == name; });
    if (found == header.end()) return std::nullopt;
    return static_cast<std::size_t>(found - header.begin());
  };
  const auto require = [&](std::string_view name) {
    if (const auto column = find(name)) return *column;
    refuse(line,
           fmt::format("there is no column \"{}\" in {}",
                       name,
                       in_quotes(fmt::format("{}", fmt::join(header, ",")))),
           "begin with the line start_s,end_s,text or tier,start_s,end_s,text (with commas)");
  };
  return {.start = require("start_s"),
          .end = require("end_s"),
          .text = require("text"),
          .tier = find("tier"),
          .count = header.size()};
}

}  // namespace

Labels parse_csv_labels(std::string_view text, std::string_view file) {
  CsvReader csv{text, file};
  const auto header = csv.next();
  if (!header) refuse({file}, "the file is empty", "begin with the line start_s,end_s,text");
  const auto columns = columns_of(*header, csv.line());
  TierBuilder builder{file};
  std::map<std::string, std::size_t> tiers;
  while (auto fields = csv.next()) {
    if (fields->size() != columns.count) {
      refuse(csv.line(),
             fmt::format("{} fields, but the first line has {}", fields->size(), columns.count),
             "write one for each column, and texts with commas in quotation marks");
    }
    const auto name = columns.tier ? fields->at(*columns.tier) : std::string{};
    auto found = tiers.find(name);
    if (found == tiers.end()) found = tiers.emplace(name, builder.add_tier(name)).first;
    builder.add(found->second,
                {.start = time_from_seconds(trimmed(fields->at(columns.start)), csv.line()),
                 .end = time_from_seconds(trimmed(fields->at(columns.end)), csv.line()),
                 .text = std::move(fields->at(columns.text))},
                csv.line().number);
  }
  auto labels = std::move(builder).finish();
  if (!columns.tier) {
    for (auto& tier : labels.tiers) tier.name = name_by_content(tier);
  }
  return labels;
}

std::string csv_labels(const Labels& labels) {
  std::string text = "tier,start_s,end_s,text\n";
  const auto write =
      [&](const std::string& tier, Duration start, Duration end, std::string_view said) {
        fmt::format_to(std::back_inserter(text),
                       "{},{},{},{}\n",
                       csv_field(tier),
                       seconds_text(start),
                       seconds_text(end),
                       csv_field(said));
      };
  for (const auto& tier : labels.tiers) {
    for (const auto& label : tier.labels) write(tier.name, label.start, label.end, label.text);
    const Duration reached = tier.labels.empty() ? Duration{} : tier.labels.back().end;
    if (reached < labels.end) write(tier.name, reached, labels.end, {});
  }
  return text;
}

}  // namespace bimodal
