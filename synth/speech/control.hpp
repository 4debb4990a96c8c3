#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace bimodal::synth {

/// What moves the face. The first group is what speech segments set (`kSpeechControls`); the rest
/// are the talker's pose and stay at neutral in experiments unless a protocol says otherwise.
enum class Control : std::uint8_t {
  Jaw,
  JawThrust,
  LipWidth,
  LipProtrusion,
  LipFunnel,
  UpperLipRaise,
  LowerLipRaise,
  LowerLipTuck,
  CornerX,
  CornerY,
  CornerZ,
  LipClosure,
  LipCompression,
  CheekPuff,
  TongueLength,
  TongueAngle,
  TongueWidth,
  TongueThickness,
  TongueTip,
  TongueBack,
  TeethX,
  TeethZ,
  LidClosure,
  RightLidClosure,
  BrowRaise,
  HeadYaw,
  HeadPitch,
  HeadRoll,
  GazeX,
  GazeY,
};

inline constexpr std::size_t kControlCount = 30;
inline constexpr std::size_t kSpeechControlCount = 20;

/// One value per control, indexed by the enumeration, each in the control's own unit.
using Pose = std::array<double, kControlCount>;

struct ControlDescription {
  Control control;
  std::string_view name;        ///< in files: "lip_width"
  std::string_view paper_name;  ///< the corresponding name in Cohen & Massaro (1993); may be empty
  std::string_view unit;        ///< "mm", "deg", "ratio"
  double lowest;                ///< the face clamps to this range, so targets may lie beyond it
  double highest;
  double neutral;
  std::string_view meaning;
  std::string_view source;  ///< who described such a control first; all ranges are of this head
};

/// One row per control, in the order of the enumeration.
[[nodiscard]] std::span<const ControlDescription, kControlCount> controls();

[[nodiscard]] const ControlDescription& describe(Control control);

/// Whether the control makes a contact at the upper end of its range (lips, or lip and teeth): a
/// target beyond is virtual and only makes the contact last.
[[nodiscard]] constexpr bool makes_contact(Control control) {
  return control == Control::LipClosure || control == Control::LowerLipTuck;
}

/// "jaw (deg)"; the name alone where the unit is a ratio: for axes and tables.
[[nodiscard]] std::string name_with_unit(Control control);

[[nodiscard]] std::optional<Control> control_from_name(std::string_view name);

/// Every control brought into its range; what is no number is neutral.
[[nodiscard]] Pose within_range(const Pose& pose);

/// Every control at neutral.
[[nodiscard]] Pose neutral_pose();

[[nodiscard]] inline double& value(Pose& pose, Control control) {
  return pose.at(static_cast<std::size_t>(control));
}

[[nodiscard]] inline double value(const Pose& pose, Control control) {
  return pose.at(static_cast<std::size_t>(control));
}

}  // namespace bimodal::synth
