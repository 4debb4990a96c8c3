#include "synth/inspection/mouth_columns.hpp"

#include <array>

namespace bimodal::synth {

namespace {

using M = MouthMeasures;

constexpr std::array kColumns{
    MouthColumn{"inner_height_mm",
                "opening between the lips on the midline",
                [](const M& m) { return m.lips.inner_height_mm; }},
    MouthColumn{"inner_width_mm",
                "width of the opening where it is higher than 0.6 mm",
                [](const M& m) { return m.lips.inner_width_mm; }},
    MouthColumn{
        "inner_area_mm2", "area of the opening", [](const M& m) { return m.lips.inner_area_mm2; }},
    MouthColumn{"outer_width_mm",
                "corner to corner of the vermilion border",
                [](const M& m) { return m.lips.outer_width_mm; }},
    MouthColumn{"outer_height_mm",
                "upper to lower vermilion border on the midline",
                [](const M& m) { return m.lips.outer_height_mm; }},
    MouthColumn{"upper_protrusion_mm",
                "upper lip forward of rest",
                [](const M& m) { return m.lips.upper_protrusion_mm; }},
    MouthColumn{"lower_protrusion_mm",
                "lower lip forward of rest",
                [](const M& m) { return m.lips.lower_protrusion_mm; }},
    MouthColumn{"corner_out_mm",
                "corners outward from rest",
                [](const M& m) { return m.lips.corner_out_mm; }},
    MouthColumn{
        "corner_up_mm", "corners upward from rest", [](const M& m) { return m.lips.corner_up_mm; }},
    MouthColumn{"corner_forward_mm",
                "corners forward of rest",
                [](const M& m) { return m.lips.corner_forward_mm; }},
    MouthColumn{"chin_drop_mm", "chin below rest", [](const M& m) { return m.lips.chin_drop_mm; }},
    MouthColumn{"jaw_deg", "opening of the jaw", [](const M& m) { return m.jaw_deg; }},
    MouthColumn{"lip_to_incisors_mm",
                "lower lip from the upper incisors; negative: in them",
                [](const M& m) { return m.lip_to_incisors_mm; }},
    MouthColumn{"upper_teeth_mm2",
                "upper teeth seen from straight ahead",
                [](const M& m) { return m.seen.upper_teeth_mm2; }},
    MouthColumn{"lower_teeth_mm2",
                "lower teeth seen from straight ahead",
                [](const M& m) { return m.seen.lower_teeth_mm2; }},
    MouthColumn{"tongue_mm2",
                "tongue seen from straight ahead",
                [](const M& m) { return m.seen.tongue_mm2; }},
    MouthColumn{"tongue_between_teeth_mm2",
                "its part between or before the teeth",
                [](const M& m) { return m.seen.tongue_between_teeth_mm2; }},
    MouthColumn{"tongue_to_ridge_mm",
                "tongue from the alveolar ridge",
                [](const M& m) { return m.tongue.to_ridge_mm; }},
    MouthColumn{"tongue_to_palate_mm",
                "tongue from the palate behind the ridge",
                [](const M& m) { return m.tongue.to_palate_mm; }},
    MouthColumn{"beside_tongue_mm",
                "between the blade's sides and the upper gum",
                [](const M& m) { return m.tongue.beside_mm; }},
};

}  // namespace

std::span<const MouthColumn> mouth_columns() {
  return kColumns;
}

}  // namespace bimodal::synth
