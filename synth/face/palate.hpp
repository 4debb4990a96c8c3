#pragma once

#include "synth/face/rigid_part.hpp"

namespace bimodal::synth {

/// The hard palate with the lingual face of the alveolar process, in the frame of the upper teeth,
/// mm. A vault between the lingual faces of the upper teeth: highest in the midline, steep at the
/// sides, coming down behind the incisors; its soft continuation falls behind z = 45. Proportions
/// chosen by us: vault 9 to 10 mm above the gum line, as in adults.
[[nodiscard]] double palate_y(double x, double z);

/// No place of it is lower, mm.
inline constexpr double kPalateLowest = -70.5;

/// Where its sheet ends: behind, and in front at the necks of the incisors.
inline constexpr double kPalateBack = 34.0;
inline constexpr double kPalateFront = 89.0;

/// Half the distance between the upper gums at depth z.
[[nodiscard]] double palate_half_width(double z);

/// The drawn sheet, facing down.
[[nodiscard]] RigidPart palate_part();

}  // namespace bimodal::synth
