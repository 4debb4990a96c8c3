#pragma once

#include <memory>

#include "synth/face/head.hpp"

namespace bimodal::synth {

/// What is seen from straight ahead, from infinitely far, mm2.
struct SeenAreas {
  double upper_teeth_mm2 = 0;
  double lower_teeth_mm2 = 0;
  double tongue_mm2 = 0;
  /// The part of the tongue that is as far in front as the back of the upper incisors' edges.
  double tongue_between_teeth_mm2 = 0;
};

/// Where the tongue is, mm.
struct TonguePlace {
  double to_ridge_mm = 0;   ///< from the alveolar ridge, 0 to 9 mm behind the incisors
  double to_palate_mm = 0;  ///< from the palate behind the ridge
  /// Between the blade's sides and the upper gum, on either side: where air passes in L.
  double beside_mm = 0;
};

/// mm; the most that parts of a face worth showing may lie in one another (chosen by us: less than
/// a pixel at 720 lines).
inline constexpr double kMostPenetration = 0.2;

/// How deep, mm, parts lie in one another at the worst place; 0: nowhere. Looked for at the corners
/// and in the middle of every triangle of the softer part.
struct Penetrations {
  double lip_in_lip = 0;
  double flesh_in_teeth = 0;  ///< lips and cheeks
  double tongue_in_teeth = 0;
  double tongue_in_palate = 0;
  double tongue_in_flesh = 0;  ///< cheeks and lips

  [[nodiscard]] double worst() const;
};

/// What of a mouth can be lipread, measured on the drawn surfaces of one pose.
struct MouthMeasures {
  LipMeasures lips;
  double jaw_deg = 0;
  double lip_to_incisors_mm = 0;  ///< lower lip from the four upper incisors; negative: in them
  SeenAreas seen;
  TonguePlace tongue;
};

/// Measures poses of one head, one after the other. `head` is borrowed.
class MouthRuler {
 public:
  explicit MouthRuler(const Head& head);
  ~MouthRuler();
  MouthRuler(const MouthRuler&) = delete;
  MouthRuler& operator=(const MouthRuler&) = delete;
  MouthRuler(MouthRuler&&) = delete;
  MouthRuler& operator=(MouthRuler&&) = delete;

  /// Takes the pose that the following measure; the head's own turning is left out.
  void take(const Pose& pose);

  [[nodiscard]] const LipMeasures& lips() const;
  [[nodiscard]] double lip_to_incisors_mm() const;
  [[nodiscard]] SeenAreas seen();
  [[nodiscard]] TonguePlace tongue() const;
  [[nodiscard]] Penetrations penetrations() const;

  /// Takes a pose and measures all but penetrations.
  [[nodiscard]] MouthMeasures measure(const Pose& pose);

 private:
  struct Tools;
  std::unique_ptr<Tools> tools_;
};

}  // namespace bimodal::synth
