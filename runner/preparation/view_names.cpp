#include "runner/preparation/view_names.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

/// The part of the head that a near view shows, in mm.
struct NearField {
  double centre_y_mm;
  double field_mm;
};

struct NamedView {
  std::string_view name;
  double yaw_deg;
  std::optional<NearField> near;  ///< absent: the whole head
};

constexpr std::array<NamedView, 4> kViews{
    {{"front", 0.0, std::nullopt},
     {"threequarter", 38.0, std::nullopt},
     {"side", 90.0, std::nullopt},
     {"mouth", 0.0, NearField{.centre_y_mm = -70.0, .field_mm = 120.0}}}};

const NamedView& view_called(std::string_view name) {
  const auto* const found = std::ranges::find(kViews, name, &NamedView::name);
  if (found != kViews.end()) return *found;
  throw Error{
      fmt::format("the face has no view '{}'; there are {}", name, fmt::join(view_names(), ", "))};
}

}  // namespace

std::vector<std::string_view> view_names() {
  std::vector<std::string_view> names;
  for (const auto& view : kViews) names.push_back(view.name);
  return names;
}

bool shows_whole_head(std::string_view name) {
  return !view_called(name).near;
}

void take_view(std::string_view name, synth::View& view) {
  const auto& named = view_called(name);
  view.yaw_deg = named.yaw_deg;
  if (!named.near) return;
  view.centre_y_mm = named.near->centre_y_mm;
  view.field_mm = named.near->field_mm;
}

}  // namespace bimodal::runner
