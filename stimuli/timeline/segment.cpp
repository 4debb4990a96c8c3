#include "stimuli/timeline/segment.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include <fmt/format.h>

namespace bimodal {

namespace {

SegmentFault no_phone(std::string_view text) {
  return {.finding = fmt::format("\"{}\" is not a phone", text),
          .remedy = fmt::format("use the symbols {}, and \"B~W:3/8\" for step 3 of 8 from B to W",
                                spell(all_phones().subspan(1)))};
}

SegmentFault no_step(std::string_view text) {
  return {.finding = fmt::format("\"{}\" names no step from one phone to another", text),
          .remedy = fmt::format("write as \"B~W:3/8\": a step from 0 to 8, of at most {} steps",
                                kMostSteps)};
}

std::optional<int> whole(std::string_view text) {
  int number = 0;
  const auto* const end = text.data() + text.size();
  const auto [stopped, fault] = std::from_chars(text.data(), end, number);
  if (fault != std::errc{} || stopped != end) return std::nullopt;
  return number;
}

}  // namespace

std::string symbol(const Segment& segment) {
  if (!segment.is_ambiguous()) return std::string{symbol(segment.from)};
  return fmt::format(
      "{}~{}:{}/{}", symbol(segment.from), symbol(segment.to), segment.step, segment.steps);
}

std::string spell(std::span<const Segment> segments) {
  std::string text;
  for (const auto& segment : segments) {
    if (!text.empty()) text += ' ';
    text += symbol(segment);
  }
  return text;
}

std::variant<Segment, SegmentFault> parse_segment(std::string_view symbol) {
  const auto tilde = symbol.find('~');
  if (tilde == std::string_view::npos) {
    const auto phone = phone_from_symbol(symbol);
    if (!phone) return no_phone(symbol);
    return Segment{*phone};
  }
  const auto colon = symbol.find(':', tilde);
  const auto slash = symbol.find('/', colon == std::string_view::npos ? tilde : colon);
  if (colon == std::string_view::npos || slash == std::string_view::npos) return no_step(symbol);
  const auto first = symbol.substr(0, tilde);
  const auto last = symbol.substr(tilde + 1, colon - tilde - 1);
  const auto from = phone_from_symbol(first);
  const auto to = phone_from_symbol(last);
  if (!from) return no_phone(first);
  if (!to) return no_phone(last);
  const auto step = whole(symbol.substr(colon + 1, slash - colon - 1));
  const auto steps = whole(symbol.substr(slash + 1));
  const bool is_on_the_way =
      step && steps && *steps >= 1 && *steps <= kMostSteps && *step >= 0 && *step <= *steps;
  if (step && steps && *steps >= 1 && *step > *steps) {
    return SegmentFault{
        .finding = fmt::format("\"{}\" goes beyond its end: {} of {} steps", symbol, *step, *steps),
        .remedy = fmt::format("give a step from 0 to {}", *steps)};
  }
  if (!is_on_the_way) return no_step(symbol);
  return Segment{*from, *to, *step, *steps};
}

std::variant<Segment, SegmentFault> parse_sound(std::string_view symbol) {
  auto read = parse_segment(symbol);
  const auto* const segment = std::get_if<Segment>(&read);
  const bool has_rest =
      segment != nullptr && (segment->from == Phone::Rest || segment->to == Phone::Rest);
  if (has_rest) read = no_phone(symbol);
  return read;
}

SpelledSegments spelled(std::span<const Segment> segments) {
  SpelledSegments written;
  for (const auto& segment : segments) written.phones.push_back(segment.nearer());
  if (std::ranges::any_of(segments, &Segment::is_ambiguous)) {
    written.articulation.assign(segments.begin(), segments.end());
  }
  return written;
}

std::vector<Segment> face_segments(const Segment& segment) {
  const auto from = face_segments(segment.from);
  const auto to = face_segments(segment.to);
  if (from.size() != to.size() && segment.step == 0) return {from.begin(), from.end()};
  if (from.size() != to.size() && segment.step == segment.steps) return {to.begin(), to.end()};
  const auto count = std::max(from.size(), to.size());
  std::vector<Segment> parts;
  for (std::size_t i = 0; i < count; ++i) {
    const Segment part{from[std::min(i, from.size() - 1)],
                       to[std::min(i, to.size() - 1)],
                       segment.step,
                       segment.steps};
    parts.push_back(part.is_ambiguous() ? part : Segment{part.from});
  }
  return parts;
}

}  // namespace bimodal
