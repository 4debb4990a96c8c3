#include "synth/speech/control.hpp"

#include <algorithm>
#include <cmath>

namespace bimodal::synth {

namespace {

using enum Control;

// Ranges and meanings are those of the project's head (synth/face), chosen by eye and from general
// phonetics; the paper's names are the nearest of Cohen & Massaro (1993). What Pearce et al. (1986)
// controlled is listed there in the section on facial animation, what was new in the one on the
// development system (tongue: Fig. 13; the rest: Fig. 14).
constexpr std::string_view kPearce = "Pearce et al. (1986)";
constexpr std::string_view kPaper = "Cohen & Massaro (1993)";
constexpr std::string_view kHere = "this head";

constexpr std::array<ControlDescription, kControlCount> kControls{{
    {Jaw, "jaw", "jaw rotation", "deg", 0, 22, 0, "opening of the lower jaw", kPearce},
    {JawThrust, "jaw_thrust", "jaw forward", "mm", -4, 6, 0, "lower jaw forward", kPaper},
    {LipWidth,
     "lip_width",
     "mouth width",
     "mm",
     -22,
     9,
     0,
     "change of the whole mouth's width",
     kPearce},
    {LipProtrusion,
     "lip_protrusion",
     "mouth z",
     "mm",
     -2,
     9,
     0,
     "both lips forward, cheeks in",
     kPearce},
    {LipFunnel, "lip_funnel", "", "ratio", 0, 1, 0, "vermilion turned outward", kHere},
    {UpperLipRaise, "upper_lip_raise", "upper lip raise", "mm", -3, 7, 0, "upper lip up", kPearce},
    {LowerLipRaise, "lower_lip_raise", "raise lower lip", "mm", -7, 7, 0, "lower lip up", kPaper},
    {LowerLipTuck,
     "lower_lip_tuck",
     "lower lip f tuck",
     "ratio",
     0,
     1,
     0,
     "lower lip rolled back and carried to the edge of the upper incisors",
     kPearce},
    {CornerX, "corner_x", "corner x", "mm", -6, 6, 0, "mouth corners outward", kPearce},
    {CornerY, "corner_y", "corner y", "mm", -6, 6, 0, "mouth corners up", kPearce},
    {CornerZ, "corner_z", "corner z", "mm", -6, 6, 0, "mouth corners forward", kPearce},
    {LipClosure,
     "lip_closure",
     "",
     "ratio",
     0,
     1,
     0,
     "part of the remaining gap between the lips that is closed",
     kHere},
    {LipCompression,
     "lip_compression",
     "roll lower lip",
     "ratio",
     0,
     1,
     0,
     "lips pressed and rolled in",
     kPaper},
    {CheekPuff, "cheek_puff", "cheek width", "ratio", -1, 1, 0, "cheeks out, times 7 mm", kPaper},
    {TongueLength,
     "tongue_length",
     "tongue length",
     "mm",
     -14,
     16,
     0,
     "tip forward along the tongue",
     kPaper},
    {TongueAngle,
     "tongue_angle",
     "tongue angle",
     "deg",
     -15,
     25,
     0,
     "whole tongue turned upward",
     kPaper},
    {TongueWidth,
     "tongue_width",
     "tongue width",
     "ratio",
     0.7,
     1.25,
     1,
     "width against rest",
     kPaper},
    {TongueThickness,
     "tongue_thickness",
     "tongue thickness",
     "ratio",
     0.6,
     1.4,
     1,
     "thickness against rest",
     kPaper},
    {TongueTip, "tongue_tip", "", "mm", -6, 16, 0, "tip curled up", kHere},
    {TongueBack, "tongue_back", "", "mm", -4, 18, 0, "dorsum raised", kHere},
    {TeethX, "teeth_x", "teeth x", "mm", -4, 4, 0, "both dental arches sideways", kPearce},
    {TeethZ, "teeth_z", "teeth z", "mm", -3, 3, 0, "both dental arches forward", kPearce},
    {LidClosure, "lid_closure", "", "ratio", -0.25, 1, 0, "both lids: 1 is shut", kHere},
    {RightLidClosure,
     "right_lid_closure",
     "",
     "ratio",
     0,
     1,
     0,
     "added for the subject's right lid",
     kHere},
    {BrowRaise, "brow_raise", "", "mm", -4, 9, 0, "brows up", kHere},
    {HeadYaw, "head_yaw", "", "deg", -60, 60, 0, "head turned to the subject's left", kHere},
    {HeadPitch, "head_pitch", "", "deg", -25, 25, 0, "head nodded", kHere},
    {HeadRoll, "head_roll", "", "deg", -20, 20, 0, "head tilted", kHere},
    {GazeX, "gaze_x", "", "deg", -30, 30, 0, "eyes to the subject's left", kHere},
    {GazeY, "gaze_y", "", "deg", -20, 20, 0, "eyes down", kHere},
}};

constexpr bool in_order_of_the_enumeration() {
  for (std::size_t i = 0; i < kControlCount; ++i) {
    if (static_cast<std::size_t>(kControls.at(i).control) != i) return false;
  }
  return true;
}

static_assert(in_order_of_the_enumeration());

}  // namespace

std::span<const ControlDescription, kControlCount> controls() {
  return kControls;
}

const ControlDescription& describe(Control control) {
  return kControls.at(static_cast<std::size_t>(control));
}

std::string name_with_unit(Control control) {
  const auto& row = describe(control);
  std::string text{row.name};
  if (row.unit != "ratio") text += " (" + std::string{row.unit} + ")";
  return text;
}

std::optional<Control> control_from_name(std::string_view name) {
  const auto* const found = std::ranges::find(kControls, name, &ControlDescription::name);
  if (found == kControls.end()) return std::nullopt;
  return found->control;
}

Pose within_range(const Pose& pose) {
  Pose result{};
  for (const auto& row : kControls) {
    const double wanted = value(pose, row.control);
    value(result, row.control) =
        std::isnan(wanted) ? row.neutral : std::clamp(wanted, row.lowest, row.highest);
  }
  return result;
}

Pose neutral_pose() {
  Pose pose{};
  std::ranges::transform(kControls, pose.begin(), &ControlDescription::neutral);
  return pose;
}

}  // namespace bimodal::synth
