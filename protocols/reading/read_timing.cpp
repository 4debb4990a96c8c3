#include "protocols/reading/read_timing.hpp"

#include <array>
#include <string_view>

namespace bimodal::protocols {

namespace {

using namespace std::chrono_literals;

constexpr std::array<std::string_view, 2> kVisualLines{"first", "mouth"};
constexpr std::array<std::string_view, 3> kFlagged{"keep", "exclude", "repeat"};

}  // namespace

Timing read_timing(ObjectReader& parent) {
  Timing timing;
  auto reader = parent.object("timing");
  if (!reader) return timing;
  if (const auto line = reader->choice("visual_line", kVisualLines)) {
    timing.visual_line = static_cast<VisualLine>(*line);
  }
  if (const auto flagged = reader->choice("flagged", kFlagged)) {
    timing.flagged = static_cast<Flagged>(*flagged);
  }
  const auto most =
      reader->whole("most_repeats", {1, 10, "how often one trial is repeated at most, e.g. 3"});
  if (most) timing.most_repeats = static_cast<int>(*most);
  const auto tolerance = reader->time(
      "offset_tolerance_ms", 1ms, {0.5, 50, "a time in milliseconds, 0.5 to 50, e.g. 4"});
  if (tolerance) timing.offset_tolerance = *tolerance;
  reader->refuse_unknown_keys();
  return timing;
}

}  // namespace bimodal::protocols
