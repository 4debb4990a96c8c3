#pragma once

#include <map>
#include <string>
#include <vector>

namespace bimodal::protocols {

/// How the synthetic face looks, beside what speech does with it. All names are those of FaceTerms.
struct Face {
  std::string view = "front";  ///< from where it is seen
  /// Colours and light: a preset, or as written a path relative to the protocol, from read_protocol
  /// a file. Empty: natural, and for points of light their own.
  std::string material;
  std::vector<std::string> show;  ///< only these parts; empty: all
  std::vector<std::string> hide;  ///< but not these
  double transparency = 0.0;      ///< of the skin: 0 opaque, 1 invisible
  std::string points = "none";    ///< where the face is nothing but points of light
  /// Expressions on top of speech, and how strongly each is shown, 0 to 1.
  std::map<std::string, double> expression;
  /// Controls that speech leaves alone, and where each stays, in its own unit.
  std::map<std::string, double> controls;

  auto operator<=>(const Face&) const = default;
};

}  // namespace bimodal::protocols
