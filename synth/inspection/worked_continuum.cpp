#include "synth/inspection/worked_continuum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "synth/speech/score_articulation.hpp"

namespace bimodal::synth {

namespace {

Milliseconds middle_of(const ContinuumToken& token) {
  const auto& segment = token.score.segments[token.segment];
  return segment.start + segment.duration / 2;
}

constexpr std::size_t kNotParted = std::numeric_limits<std::size_t>::max();

/// The opening of the lips, sampled from before the closure at the middle of a segment, if there is
/// one, to kOpeningTime after its end.
struct Opening {
  std::vector<double> time_ms;
  std::vector<double> height_mm;
  std::size_t middle = 0;  ///< index of the segment's middle

  /// Index of the first sample from the middle on at which the lips are not shut.
  [[nodiscard]] std::size_t parting() const {
    for (auto i = middle; i < height_mm.size(); ++i) {
      if (height_mm[i] > kShutGapMm) return i;
    }
    return kNotParted;
  }
};

Opening opening_about(const ContinuumToken& token,
                      ScoreArticulation& articulation,
                      const Head& head) {
  constexpr double kStep = 4.0;  // ms; between samples the height is taken to run straight
  const double middle = middle_of(token).count();
  PosedHead posed;
  const auto height_at = [&](double time) {
    head.pose(articulation.at(Milliseconds{time}), posed);
    return posed.lips.inner_height_mm;
  };
  // Steps are counted from the middle, so that it is a sample.
  Opening opening;
  const auto add = [&](double time) {
    opening.time_ms.push_back(time);
    opening.height_mm.push_back(height_at(time));
  };
  for (double time = middle; time > 0; time -= kStep) {
    add(time);
    if (opening.height_mm.back() > kShutGapMm) break;
  }
  std::ranges::reverse(opening.time_ms);
  std::ranges::reverse(opening.height_mm);
  opening.middle = opening.time_ms.size() - 1;
  const double end = token.score.end().count();
  const auto is_open = [&] { return opening.height_mm.back() > kShutGapMm; };
  auto last = is_open() ? std::min(end, middle + kOpeningTime.count()) : end;
  for (double time = middle + kStep; time < last; time += kStep) {
    add(time);
    if (last == end && is_open()) last = std::min(end, time + kOpeningTime.count() + kStep);
  }
  return opening;
}

/// When a straight line between two samples reaches `height`.
double crossing(const Opening& opening, std::size_t after, double height) {
  const double before = opening.height_mm[after - 1];
  const double rise = opening.height_mm[after] - before;
  const double share = rise == 0 ? 0 : std::clamp((height - before) / rise, 0.0, 1.0);
  return std::lerp(opening.time_ms[after - 1], opening.time_ms[after], share);
}

Milliseconds time_shut(const Opening& opening) {
  if (opening.height_mm[opening.middle] > kShutGapMm) return {};
  const auto& times = opening.time_ms;
  const bool was_open = opening.height_mm.front() > kShutGapMm;
  const double from = was_open ? crossing(opening, 1, kShutGapMm) : times.front();
  const auto parting = opening.parting();
  const double to = parting == kNotParted ? times.back() : crossing(opening, parting, kShutGapMm);
  return Milliseconds{to - from};
}

/// From the parting of the lips (from the middle, if they are open then) on.
void measure_release(const Opening& opening, TokenMiddle& middle) {
  const auto parting = opening.parting();
  if (parting == kNotParted) return;
  const bool is_shut = parting > opening.middle;
  const auto first = is_shut ? parting - 1 : opening.middle;
  const double begin =
      is_shut ? crossing(opening, parting, kShutGapMm) : opening.time_ms[opening.middle];
  double greatest = 0;
  double fastest = 0;
  for (auto i = first + 1; i < opening.height_mm.size(); ++i) {
    greatest = std::max(greatest, opening.height_mm[i]);
    const double step = opening.time_ms[i] - opening.time_ms[i - 1];
    fastest = std::max(fastest, (opening.height_mm[i] - opening.height_mm[i - 1]) / step * 1e3);
  }
  middle.fastest_opening_mm_per_s = fastest;
  const double half = greatest / 2;
  if (greatest <= kShutGapMm || opening.height_mm[first] >= half) return;
  auto after = first + 1;
  while (opening.height_mm[after] < half) ++after;
  middle.half_open = Milliseconds{crossing(opening, after, half) - begin};
}

TokenMiddle middle_face(const ContinuumToken& token,
                        ScoreArticulation& articulation,
                        const Head& head) {
  const auto time = middle_of(token);
  TokenMiddle middle;
  middle.pose = articulation.at(time);
  middle.released = articulation.at(token.score.segments[token.segment].end() + kReleased);
  PosedHead posed;
  head.pose(middle.pose, posed);
  middle.lips = posed.lips;
  const auto opening = opening_about(token, articulation, head);
  middle.shut = time_shut(opening);
  measure_release(opening, middle);
  return middle;
}

}  // namespace

Continuum worked_out(std::vector<ContinuumToken> tokens,
                     const SegmentTable& table,
                     Account account,
                     const Head& head) {
  Continuum continuum{.tokens = std::move(tokens), .claims = {}, .middles = {}, .account = account};
  for (const auto& token : continuum.tokens) {
    continuum.claims.push_back(claims_of(token.score, table));
    ScoreArticulation articulation{continuum.claims.back(), account};
    continuum.middles.push_back(middle_face(token, articulation, head));
  }
  return continuum;
}

std::string token_name(const Continuum& continuum, std::size_t token) {
  const auto digits = fmt::to_string(continuum.tokens.size() - 1).size();
  return fmt::format("token{:0{}}", token, digits);
}

std::vector<std::string> cautions(const Continuum& continuum) {
  constexpr double kNoticed = 0.02;  // mm: less is rounding in the mesh
  const auto height = [&](std::size_t i) { return continuum.middles[i].lips.inner_height_mm; };
  const double whole = height(continuum.tokens.size() - 1) - height(0);
  std::vector<std::string> found;
  if (std::abs(whole) < kNoticed) return found;
  for (std::size_t i = 1; i < continuum.tokens.size(); ++i) {
    const double step = height(i) - height(i - 1);
    if (step * whole >= 0 || std::abs(step) < kNoticed) continue;
    found.push_back(fmt::format("from {} to {} the lips {} by {:.2f} mm, against the others",
                                token_name(continuum, i - 1),
                                token_name(continuum, i),
                                step > 0 ? "open" : "close",
                                std::abs(step)));
  }
  return found;
}

}  // namespace bimodal::synth
