#include "synth/fitting/lip_timing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bimodal::synth {

namespace {

constexpr double kClosureBeforeMs = 120;
constexpr double kClosureBehindMs = 60;
constexpr double kNearMm = 0.5;
constexpr double kRoundingBeforeMs = 100;
constexpr double kRoundingBehindMs = 150;
constexpr double kFallMs = 400;

/// The first index at or after `time_ms`.
std::size_t index_at(const Course& course, double time_ms) {
  return static_cast<std::size_t>(std::ranges::lower_bound(course.time_ms, time_ms) -
                                  course.time_ms.begin());
}

struct Lowest {
  std::size_t index = 0;
  bool is_turn = false;  ///< the course is higher at both ends of the window
};

/// The least value within a window; absent where that has fewer than three instants.
std::optional<Lowest> lowest_within(const Course& course, double from_ms, double to_ms) {
  const auto first = index_at(course, from_ms);
  const auto last = index_at(course, to_ms);
  if (last < first + 3) return std::nullopt;
  const auto window = course.values.subspan(first, last - first);
  const auto lowest = std::ranges::min_element(window);
  return Lowest{.index = first + static_cast<std::size_t>(lowest - window.begin()),
                .is_turn = window.front() > *lowest && window.back() > *lowest};
}

/// When the straight line between two neighbouring instants has `level`.
double crossing(const Course& course, std::size_t earlier, double level) {
  const double one = course.values[earlier];
  const double other = course.values[earlier + 1];
  const double share = (level - one) / (other - one);
  return std::lerp(course.time_ms[earlier], course.time_ms[earlier + 1], share);
}

/// When the course was last at `level` or above before `index`; absent if never.
std::optional<double> reached_before(const Course& course, std::size_t index, double level) {
  for (std::size_t i = index; i-- > 0;) {
    if (course.values[i] >= level) return crossing(course, i, level);
  }
  return std::nullopt;
}

std::optional<double> left_after(const Course& course, std::size_t index, double level) {
  for (std::size_t i = index; i + 1 < course.values.size(); ++i) {
    if (course.values[i + 1] >= level) return crossing(course, i, level);
  }
  return std::nullopt;
}

double start_of(const TimedPhone& phone) {
  return Milliseconds{phone.start}.count();
}

double end_of(const TimedPhone& phone) {
  return Milliseconds{phone.end()}.count();
}

}  // namespace

bool closes_lips(Phone phone) {
  return phone == Phone::P || phone == Phone::B || phone == Phone::M;
}

bool rounds_lips(Phone phone) {
  return phone == Phone::W || phone == Phone::WH || phone == Phone::UW;
}

std::optional<Closure> closure(const Course& inner_height, const TimedPhone& phone) {
  const auto lowest = lowest_within(
      inner_height, start_of(phone) - kClosureBeforeMs, end_of(phone) + kClosureBehindMs);
  if (!lowest) return std::nullopt;
  Closure found{.lowest_mm = inner_height.values[lowest->index]};
  const auto begin = reached_before(inner_height, lowest->index, found.lowest_mm + kNearMm);
  const auto end = left_after(inner_height, lowest->index, found.lowest_mm + kNearMm);
  if (lowest->is_turn && begin && end) found.time_ms = std::midpoint(*begin, *end);
  return found;
}

std::optional<Rounding> rounding(const Course& outer_width,
                                 const TimedPhone& phone,
                                 double least_fall_mm) {
  const auto narrowest = lowest_within(
      outer_width, start_of(phone) - kRoundingBeforeMs, end_of(phone) + kRoundingBehindMs);
  if (!narrowest || !narrowest->is_turn) return std::nullopt;
  const double time = outer_width.time_ms[narrowest->index];
  const double least = outer_width.values[narrowest->index];
  const auto first = index_at(outer_width, time - kFallMs);
  const double widest =
      *std::ranges::max_element(outer_width.values.subspan(first, narrowest->index + 1 - first));
  const double fall = widest - least;
  if (fall < least_fall_mm) return std::nullopt;
  const auto half = reached_before(outer_width, narrowest->index, least + fall / 2);
  return Rounding{.fall_mm = fall, .half_way_ms = half.value(), .narrowest_ms = time};
}

Middle middle_of(std::vector<double> values) {
  Middle found{.count = values.size()};
  if (values.empty()) return found;
  std::ranges::sort(values);
  const auto half = values.size() / 2;
  found.median = values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
  if (values.size() < 2) return found;
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  found.sd = std::sqrt(squares / (count - 1));
  return found;
}

}  // namespace bimodal::synth
