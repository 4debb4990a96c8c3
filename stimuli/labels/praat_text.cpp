#include "stimuli/labels/praat_text.hpp"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "stimuli/labels/label_time.hpp"

namespace bimodal {

namespace {

bool is_blank(char letter) {
  return letter == ' ' || (letter >= '\t' && letter <= '\r');
}

bool is_within_word(char letter) {
  return !is_blank(letter);
}

bool is_within_line(char letter) {
  return letter != '\n';
}

bool begins_number(char letter) {
  return (letter >= '0' && letter <= '9') || letter == '-' || letter == '+';
}

}  // namespace

void PraatText::skip_while(bool (*is_skipped)(char)) {
  for (; at_ < text_.size() && is_skipped(text_[at_]); ++at_) {
    if (text_[at_] == '\n') ++line_;
  }
}

PraatText::Kind PraatText::find_value() {
  while (true) {
    skip_while(is_blank);
    value_line_ = line_;
    if (at_ == text_.size()) return Kind::Nothing;
    const char first = text_[at_];
    if (begins_number(first)) return Kind::Number;
    if (first == '"') return Kind::String;
    if (first == '<') return Kind::Flag;
    skip_while(first == '!' ? is_within_line : is_within_word);
  }
}

bool PraatText::at_end() {
  return find_value() == Kind::Nothing;
}

void PraatText::expect(Kind kind, std::string_view what) {
  const Kind found = find_value();
  if (found == kind) return;
  if (found == Kind::Nothing) {
    refuse(line(),
           fmt::format("the file ends where {} should be", what),
           "is it whole? Save it again from Praat");
  }
  const auto rest = text_.substr(at_);
  refuse(line(),
         fmt::format(
             "{} where {} should be", in_quotes(trimmed(rest.substr(0, rest.find('\n')))), what),
         "save it again from Praat");
}

std::string_view PraatText::take_word() {
  const std::size_t begin = at_;
  skip_while(is_within_word);
  return text_.substr(begin, at_ - begin);
}

std::string PraatText::take_string(std::string_view what) {
  expect(Kind::String, what);
  std::string value;
  ++at_;
  while (true) {
    const auto quote = text_.find('"', at_);
    if (quote == std::string_view::npos) {
      refuse(line(), "the text that begins here does not end", "close it with a quotation mark");
    }
    for (; at_ < quote; ++at_) {
      if (text_[at_] == '\n') ++line_;
      value += text_[at_];
    }
    ++at_;
    if (at_ == text_.size() || text_[at_] != '"') break;
    value += '"';
    ++at_;
  }
  if (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '!') {
    refuse({file_, line_},
           fmt::format("{} goes on behind its quotation mark", in_quotes(value)),
           "write \"\" for a quotation mark within a text");
  }
  return value;
}

Duration PraatText::take_seconds(std::string_view what) {
  expect(Kind::Number, what);
  return time_from_seconds(take_word(), line());
}

std::size_t PraatText::take_count(std::string_view what) {
  expect(Kind::Number, what);
  const auto word = take_word();
  std::size_t count = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (error != std::errc{} || stop != word.data() + word.size()) {
    refuse(line(),
           fmt::format("{} is not {}", in_quotes(word), what),
           "write a whole number from 0, or save it again from Praat");
  }
  return count;
}

double PraatText::take_number(std::string_view what) {
  expect(Kind::Number, what);
  const auto word = take_word();
  double number = 0.0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc{} || stop != word.data() + word.size() || !std::isfinite(number)) {
    refuse(line(),
           fmt::format("{} is not {}", in_quotes(word), what),
           "write a number with a decimal point, or save it again from Praat");
  }
  return number;
}

std::string PraatText::take_flag(std::string_view what) {
  expect(Kind::Flag, what);
  const auto word = take_word();
  if (!word.ends_with('>')) {
    refuse(line(), fmt::format("{} lacks its \">\"", in_quotes(word)), "save it again from Praat");
  }
  return std::string{word.substr(1, word.size() - 2)};
}

}  // namespace bimodal
