#include "synth/speech/continuum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/nearest.hpp"
#include "synth/speech/durations.hpp"

namespace bimodal::synth {

namespace {

constexpr std::string_view kPlace = "_";
constexpr std::array<std::string_view, 5> kParameters{
    "target", "alpha", "theta_before", "theta_after", "offset_ms"};

/// A context's words with the place taken by `symbol`; "_:120" gives it a duration.
std::string filled(const std::string& context, const std::string& symbol) {
  std::string text;
  std::size_t places = 0;
  std::istringstream words{context};
  for (std::string word; words >> word;) {
    if (!text.empty()) text += ' ';
    if (word == kPlace || word.starts_with("_:")) {
      ++places;
      text += symbol + word.substr(1);
    } else {
      text += word;
    }
  }
  if (places != 1) {
    throw Error{
        fmt::format("the context \"{}\" has {} places for the sound; write one \"_\", e.g. "
                    "\"_ AA\" or \"AA _ AA\"",
                    context,
                    places)};
  }
  return text;
}

/// Where the place stands among the segments that typed_segments makes of the context.
std::size_t index_of_place(const std::string& context) {
  std::istringstream words{context};
  std::size_t index = 0;
  std::string first;
  for (std::string word; words >> word; ++index) {
    if (first.empty()) first = word;
    if (word == kPlace || word.starts_with("_:")) break;
  }
  const auto parsed = parse_segment(first.substr(0, first.find(':')));
  const auto* const segment = std::get_if<Segment>(&parsed);
  const bool has_rest = segment != nullptr && *segment == Phone::Rest;
  return has_rest ? index : index + 1;  // typed_segments puts one before
}

void set(SegmentTarget& asked, Varied parameter, double value) {
  switch (parameter) {
    case Varied::Target:
      asked.target = value;
      break;
    case Varied::Alpha:
      asked.dominance.alpha = value;
      break;
    case Varied::ThetaBefore:
      asked.dominance.theta_before = value;
      break;
    case Varied::ThetaAfter:
      asked.dominance.theta_after = value;
      break;
    case Varied::OffsetMs:
      asked.offset = Milliseconds{value};
      break;
  }
}

void judge(const ContinuumDesign& design) {
  if (design.steps < 2 || design.steps > kMostSteps) {
    throw Error{fmt::format("a continuum of {} steps; give 2 to {}", design.steps, kMostSteps)};
  }
  if (design.to && *design.to == design.from) {
    throw Error{fmt::format("both ends are {}; give two sounds, or --vary a control of one",
                            symbol(design.from))};
  }
  if (design.to) return;
  if (design.varied.empty()) {
    throw Error{"nothing varies; give a second sound, or controls to vary"};
  }
  if (face_segments(design.from).size() > 1) {
    throw Error{
        fmt::format("{} is two segments for the face; vary one of them, with the other in "
                    "the context",
                    symbol(design.from))};
  }
  const bool is_usable =
      std::isfinite(design.low) && std::isfinite(design.high) && design.low != design.high;
  if (!is_usable) {
    throw Error{fmt::format("from {} to {} is no way; give two numbers", design.low, design.high)};
  }
  for (const auto& varied : design.varied) {
    const bool must_be_positive =
        varied.parameter != Varied::Target && varied.parameter != Varied::OffsetMs;
    if (must_be_positive && std::min(design.low, design.high) <= 0) {
      throw Error{fmt::format("{} must be above 0; {} is not",
                              kParameters.at(static_cast<std::size_t>(varied.parameter)),
                              std::min(design.low, design.high))};
    }
  }
}

/// Steps between two sounds. The durations are those of the first.
ContinuumToken token_between(const ContinuumDesign& design, std::size_t step) {
  const auto last = static_cast<int>(design.steps) - 1;
  const Segment at{design.from.from, design.to->from, static_cast<int>(step), last};
  auto segments = typed_segments(filled(design.context, symbol(design.from)));
  const auto place = index_of_place(design.context);
  segments[place].segment = at;
  return {.name = symbol(at),
          .place = static_cast<double>(step) / last,
          .score = score_of(segments),
          .segment = place};
}

ContinuumToken token_along(const ContinuumDesign& design,
                           const SegmentTable& table,
                           std::size_t step) {
  const double place = static_cast<double>(step) / static_cast<double>(design.steps - 1);
  const double value = std::lerp(design.low, design.high, place);
  ContinuumToken token{
      .name = fmt::format("{} {:.4g}", symbol(design.from), value),
      .place = place,
      .score = score_of(typed_segments(filled(design.context, symbol(design.from)))),
      .segment = index_of_place(design.context)};
  auto& segment = token.score.segments[token.segment];
  for (const auto& varied : design.varied) {
    const std::string name{describe(varied.control).name};
    const auto known = segment.controls.find(name);
    auto asked =
        known != segment.controls.end() ? known->second : table.at(design.from, varied.control);
    set(asked, varied.parameter, value);
    segment.controls[name] = asked;
  }
  return token;
}

}  // namespace

VariedParameter parse_varied(std::string_view text) {
  const auto dot = text.find('.');
  const auto name = text.substr(0, dot);
  const auto control = control_from_name(name);
  if (!control || static_cast<std::size_t>(*control) >= kSpeechControlCount) {
    std::vector<std::string_view> known;
    for (const auto& row : controls().first<kSpeechControlCount>()) known.push_back(row.name);
    const auto near = nearest(name, known);
    throw Error{fmt::format("\"{}\" is no control that speech sets; {}there are {}",
                            name,
                            near ? fmt::format("did you mean \"{}\"? ", *near) : "",
                            fmt::join(known, ", "))};
  }
  if (dot == std::string_view::npos) return {.control = *control};
  const auto parameter = text.substr(dot + 1);
  const auto* const found = std::ranges::find(kParameters, parameter);
  if (found == kParameters.end()) {
    throw Error{fmt::format("\"{}\" is no parameter of a control; there are {}",
                            parameter,
                            fmt::join(kParameters, ", "))};
  }
  return {.control = *control, .parameter = static_cast<Varied>(found - kParameters.begin())};
}

std::vector<ContinuumToken> tokens_of(const ContinuumDesign& design, const SegmentTable& table) {
  judge(design);
  std::vector<ContinuumToken> tokens;
  tokens.reserve(design.steps);
  for (std::size_t step = 0; step < design.steps; ++step) {
    tokens.push_back(design.to ? token_between(design, step) : token_along(design, table, step));
  }
  return tokens;
}

}  // namespace bimodal::synth
