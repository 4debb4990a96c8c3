#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bimodal::protocols {

/// A name of a part of the face, or of several ("teeth").
struct FacePart {
  std::string_view name;
  std::uint32_t parts = 0;  ///< one bit for each that it stands for
};

/// A control that speech leaves alone, and that a protocol may set; at rest it is at 0.
struct FaceControl {
  std::string_view name;
  std::string_view unit;
  double lowest = 0.0;
  double highest = 0.0;
};

/// An expression, and what it adds at full strength to controls that speech leaves alone.
struct FaceExpression {
  std::string_view name;
  std::map<std::string_view, double> adds;  ///< by the control's name, in its unit
};

/// What a protocol may ask of the synthetic face, told by whoever has one: protocols know none.
/// Empty: nothing may be asked.
struct FaceTerms {
  std::vector<std::string_view> views;
  std::vector<std::string_view> points;
  std::vector<std::string> materials;  ///< presets
  std::vector<FacePart> parts;
  std::vector<FaceExpression> expressions;
  std::vector<FaceControl> controls;
  std::vector<std::string_view> speech_controls;  ///< known, and not to be set
};

}  // namespace bimodal::protocols
