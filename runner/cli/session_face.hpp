#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocols/design/plan.hpp"
#include "protocols/reading/read_protocol.hpp"
#include "runner/preparation/face_quality.hpp"
#include "runner/preparation/shown_look.hpp"
#include "runner/store/records.hpp"

namespace bimodal::runner {

/// The synthetic face of a session, before it is known how often the display refreshes.
struct SessionFace {
  ShownLook look;                        ///< the costliest
  std::optional<Duration> full_picture;  ///< in full quality; absent: not measured
  std::string renderer;                  ///< OpenGL's description
};

/// Absent if no trial of `plan` shows one. Measures if that matters, for about a second or two.
/// `watched`: somebody will look at it. Throws Error if it cannot be drawn.
[[nodiscard]] std::optional<SessionFace> examine_face(
    const protocols::ReadProtocol& read,
    const std::vector<protocols::PlannedTrial>& plan,
    bool watched);

/// The quality in which it is drawn for a display that shows `drawing_rate` pictures a second.
[[nodiscard]] ChosenQuality quality_of(const SessionFace& face,
                                       const protocols::Protocol& protocol,
                                       Hertz drawing_rate);

[[nodiscard]] FaceDrawingRecord record_of(const SessionFace& face, const ChosenQuality& chosen);

}  // namespace bimodal::runner
