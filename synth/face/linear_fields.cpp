#include "synth/face/linear_fields.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace bimodal::synth {

namespace {

constexpr std::array<std::pair<Control, std::string_view>, 9> kFieldOfControl{{
    {Control::LipProtrusion, "protrude"},
    {Control::LipFunnel, "funnel"},
    {Control::UpperLipRaise, "upraise"},
    {Control::LowerLipRaise, "lowraise"},
    {Control::CornerX, "cornx"},
    {Control::CornerY, "corny"},
    {Control::CornerZ, "cornz"},
    {Control::CheekPuff, "puff"},
    {Control::BrowRaise, "brow"},
}};

void add(std::span<glm::dvec3> skin, std::span<const glm::dvec3> field, double amount) {
  if (amount == 0.0) return;
  for (std::size_t i = 0; i < skin.size(); ++i) skin[i] += amount * field[i];
}

}  // namespace

LinearFields::LinearFields(const FieldTable& table)
    : width_{table.vectors("width")},
      narrow_{table.vectors("narrow")},
      width_thin_{table.vectors("width_thin")} {
  for (const auto& [control, name] : kFieldOfControl) {
    fields_.push_back({control, table.vectors(name)});
  }
  // Per degree the lower lip hugs the teeth (0.17 mm up, 0.10 back), the upper lip rises 0.03 mm,
  // and the mouth narrows.
  const auto hug = table.column("hug");
  const auto raise = table.vectors("upraise");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    jaw_drag_.push_back(glm::dvec3{0.0, 0.17 * hug[i] + 0.03 * raise[i].y, -0.10 * hug[i]} -
                        0.10 * narrow_[i]);
  }
}

void LinearFields::move(const Pose& pose, std::span<glm::dvec3> skin) const {
  const double width = value(pose, Control::LipWidth);
  add(skin, width >= 0.0 ? width_ : narrow_, 0.5 * width);
  add(skin, width_thin_, width >= 0.0 ? width : 0.25 * width);
  for (const auto& [control, per_unit] : fields_) add(skin, per_unit, value(pose, control));
  add(skin, jaw_drag_, value(pose, Control::Jaw));
}

}  // namespace bimodal::synth
