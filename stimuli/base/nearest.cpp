#include "stimuli/base/nearest.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "stimuli/base/lower_case.hpp"

namespace bimodal {

namespace {

constexpr std::size_t kLongestTyped = 64;  ///< bytes; longer ones are no slips of the finger

}  // namespace

std::size_t edit_distance(std::string_view one, std::string_view other) {
  const std::size_t width = other.size() + 1;
  std::vector<std::size_t> before_previous(width);
  std::vector<std::size_t> previous(width);
  std::vector<std::size_t> current(width);
  for (std::size_t j = 0; j < width; ++j) previous[j] = j;
  for (std::size_t i = 1; i <= one.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j < width; ++j) {
      const std::size_t replaced = previous[j - 1] + (one[i - 1] == other[j - 1] ? 0 : 1);
      current[j] = std::min({replaced, previous[j] + 1, current[j - 1] + 1});
      const bool exchanged =
          i > 1 && j > 1 && one[i - 1] == other[j - 2] && one[i - 2] == other[j - 1];
      if (exchanged) current[j] = std::min(current[j], before_previous[j - 2] + 1);
    }
    std::swap(before_previous, previous);
    std::swap(previous, current);
  }
  return previous.back();
}

std::optional<std::string_view> nearest(std::string_view typed,
                                        std::span<const std::string_view> known) {
  if (typed.empty() || typed.size() > kLongestTyped) return std::nullopt;
  const std::string folded = lower_case(typed);
  std::optional<std::string_view> best;
  std::size_t smallest = 0;
  for (const std::string_view candidate : known) {
    const std::string folded_candidate = lower_case(candidate);
    const bool is_its_start = folded.size() >= 3 && folded_candidate.starts_with(folded + "_");
    const std::size_t distance = is_its_start ? 1 : edit_distance(folded, folded_candidate);
    const bool same_start = !candidate.empty() && folded_candidate.front() == folded.front();
    const std::size_t forgiven =
        same_start ? std::max<std::size_t>(2, folded.size() / 3) : folded.size() / 3;
    if (distance <= forgiven && (!best || distance < smallest)) {
      best = candidate;
      smallest = distance;
    }
  }
  return best;
}

}  // namespace bimodal
