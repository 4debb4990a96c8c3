#include "runner/monitor/screen_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "stimuli/base/utf8.hpp"

namespace bimodal::runner {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kNameWidth = 16;

std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

/// The first characters, at most `count`.
std::string_view beginning(std::string_view text, std::size_t count) {
  std::size_t at = 0;
  for (; count > 0 && at < text.size(); --count) {
    at += std::max<std::size_t>(utf8_length(text, at), 1);
  }
  return text.substr(0, at);
}

bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return first < 0x20U || first == 0x7FU;
  return character.size() == 2 && first == 0xC2U &&
         static_cast<unsigned char>(character[1]) < 0xA0U;
}

}  // namespace

std::string harmless(std::string_view text) {
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const auto length = utf8_length(text, at);
    const auto character = text.substr(at, std::max<std::size_t>(length, 1));
    shown += length == 0 || is_control(character) ? "?" : character;
    at += character.size();
  }
  return shown;
}

std::string fitted(std::string_view text, std::size_t width) {
  constexpr std::string_view kCut = "..";
  const auto wide = columns(text);
  if (wide <= width) return std::string{text} + std::string(width - wide, ' ');
  if (width <= kCut.size()) return std::string{beginning(text, width)};
  return std::string{beginning(text, width - kCut.size())} + std::string{kCut};
}

std::string apart(std::string_view left, std::string_view right, std::size_t width) {
  const auto wide = std::min(columns(right), width);
  return fitted(left, width - wide) + fitted(right, wide);
}

std::string clock_text(Duration duration) {
  const auto seconds = std::max(std::chrono::floor<std::chrono::seconds>(duration), 0s).count();
  const auto minutes = seconds / 60;
  if (minutes < 60) return fmt::format("{}:{:02}", minutes, seconds % 60);
  return fmt::format("{}:{:02}:{:02}", minutes / 60, minutes % 60, seconds % 60);
}

std::string rough_text(Duration duration) {
  const auto minutes = std::chrono::floor<std::chrono::minutes>(duration + 30s).count();
  if (minutes < 1) return "less than a minute";
  if (minutes < 60) return fmt::format("about {} min", minutes);
  return fmt::format("about {} h {} min", minutes / 60, minutes % 60);
}

std::string bar(std::size_t done, std::size_t of, std::size_t width) {
  if (width < 2) return {};
  const auto inner = width - 2;
  const auto filled = of == 0 ? 0 : std::min(done, of) * inner / of;
  return "[" + std::string(filled, '#') + std::string(inner - filled, '-') + "]";
}

std::vector<std::string> condition_table(const std::vector<ConditionTally>& tallies,
                                         std::size_t rows) {
  std::vector<std::string> table{
      fmt::format("{} trials  as spelled", fitted("condition", kNameWidth))};
  const bool all = tallies.size() + 1 <= rows;
  const auto shown = all ? tallies.size() : std::max<std::size_t>(rows, 2) - 2;
  for (std::size_t i = 0; i < shown; ++i) {
    const auto& tally = tallies[i];
    auto row = fmt::format("{} {:6}", fitted(harmless(tally.condition), kNameWidth), tally.trials);
    if (tally.judged > 0) {
      row += fmt::format(
          "  {:4}  {:3.0f} %",
          tally.spelled_as_target,
          100.0 * static_cast<double>(tally.spelled_as_target) / static_cast<double>(tally.judged));
    }
    table.push_back(std::move(row));
  }
  if (!all) table.push_back(fmt::format("and {} more", tallies.size() - shown));
  return table;
}

}  // namespace bimodal::runner
