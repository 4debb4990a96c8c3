#include "stimuli/base/csv_reader.hpp"

#include <charconv>
#include <system_error>

#include <fmt/format.h>

#include "stimuli/base/diagnostic.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

constexpr std::size_t kMostFields = 1'000;  ///< of one record
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

[[noreturn]] void refuse_at(std::string_view file,
                            std::size_t line,
                            std::string_view finding,
                            std::string_view remedy) {
  throw Error{describe(Diagnostic{.file = std::string{file},
                                  .line = line,
                                  .finding = std::string{finding},
                                  .remedy = std::string{remedy}})};
}

/// Short enough for a message.
std::string excerpt(std::string_view field) {
  constexpr std::size_t kMost = 40;
  return fmt::format("\"{}{}\"", field.substr(0, kMost), field.size() > kMost ? "..." : "");
}

char delimiter_of(std::string_view text) {
  while (text.starts_with("# ") && text.find('\n') != std::string_view::npos) {
    text.remove_prefix(text.find('\n') + 1);
  }
  const auto line = text.substr(0, text.find_first_of("\r\n"));
  if (line.find(',') != std::string_view::npos) return ',';
  if (line.find(';') != std::string_view::npos) return ';';
  return line.find('\t') != std::string_view::npos ? '\t' : ',';
}

}  // namespace

CsvReader::CsvReader(std::string_view text, std::string_view file, char delimiter)
    : text_{text}, file_{file}, delimiter_{delimiter == '\0' ? delimiter_of(text) : delimiter} {
  if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
}

std::vector<std::string> CsvReader::take_remarks() {
  constexpr std::string_view kMark = "# ";
  std::vector<std::string> remarks;
  while (text_.substr(at_).starts_with(kMark)) {
    const auto begin = at_ + kMark.size();
    while (at_ < text_.size() && !at_end_of_line()) ++at_;
    remarks.emplace_back(text_.substr(begin, at_ - begin));
    if (at_ < text_.size()) step();
  }
  return remarks;
}

std::optional<std::vector<std::string>> CsvReader::next() {
  while (at_ < text_.size() && at_end_of_line()) step();
  line_ = reached_line_;
  if (at_ >= text_.size()) return std::nullopt;
  std::vector<std::string> fields;
  while (true) {
    if (fields.size() == kMostFields) {
      refuse(fmt::format("more than {} fields", kMostFields), "is this the right file?");
    }
    fields.push_back(take_field());
    if (at_ == text_.size()) return fields;
    const bool goes_on = text_[at_] == delimiter_;
    step();
    if (!goes_on) return fields;
  }
}

void CsvReader::refuse(std::string_view finding, std::string_view remedy) const {
  refuse_at(file_, line_, finding, remedy);
}

/// Beyond one letter, or one end of a line.
void CsvReader::step() {
  if (text_[at_] == '\r') ++at_;
  if (text_[at_] == '\n') ++reached_line_;
  ++at_;
}

bool CsvReader::at_end_of_line() const {
  return text_[at_] == '\n' || text_.substr(at_).starts_with("\r\n");
}

std::string CsvReader::take_field() {
  if (at_ < text_.size() && text_[at_] == '"') return take_quoted_field();
  const auto begin = at_;
  while (at_ < text_.size() && text_[at_] != delimiter_ && !at_end_of_line()) ++at_;
  const auto field = text_.substr(begin, at_ - begin);
  const bool quote = field.find('"') != std::string_view::npos;
  if (quote || field.find('\r') != std::string_view::npos) {
    refuse_at(
        file_,
        reached_line_,
        fmt::format(
            "{} within {}", quote ? "a quotation mark" : "a lone carriage return", excerpt(field)),
        quote ? "put the whole field in quotation marks, and two where one is meant"
              : "end lines by line feeds, with or without carriage returns before them");
  }
  return std::string{field};
}

std::string CsvReader::take_quoted_field() {
  const auto begin = reached_line_;
  std::string field;
  ++at_;
  while (at_ < text_.size()) {
    const bool quote = text_[at_] == '"';
    if (quote && (at_ + 1 == text_.size() || text_[at_ + 1] != '"')) {
      ++at_;
      if (at_ < text_.size() && text_[at_] != delimiter_ && !at_end_of_line()) {
        refuse_at(file_,
                  reached_line_,
                  fmt::format("{} goes on behind its quotation mark", excerpt(field)),
                  "write \"\" for a quotation mark within a field");
      }
      return field;
    }
    if (text_[at_] == '\n') ++reached_line_;
    field += text_[at_];
    at_ += quote ? 2 : 1;
  }
  refuse_at(file_,
            begin,
            "the quoted field that begins here does not end",
            "close it with a quotation mark");
}

std::optional<std::int64_t> csv_count(std::string_view field) {
  constexpr std::int64_t kMost = 1'000'000'000;
  const auto first = field.find_first_not_of(' ');
  if (first == std::string_view::npos) return std::nullopt;
  field = field.substr(first, field.find_last_not_of(' ') - first + 1);
  std::int64_t count = 0;
  const auto* const end = field.data() + field.size();
  const auto [reached, fault] = std::from_chars(field.data(), end, count);
  if (fault != std::errc{} || reached != end || count < 0 || count > kMost) return std::nullopt;
  return count;
}

}  // namespace bimodal
