#include "runner/cli/session_face.hpp"

#include <algorithm>

#include "runner/preparation/drawing_pace.hpp"
#include "synth/render/opengl_description.hpp"

namespace bimodal::runner {

std::optional<SessionFace> examine_face(const protocols::ReadProtocol& read,
                                        const std::vector<protocols::PlannedTrial>& plan,
                                        bool watched) {
  const auto look = costliest_face(read.protocol, plan, read.corpora);
  if (!look) return std::nullopt;
  SessionFace face{
      .look = *look, .full_picture = std::nullopt, .renderer = synth::opengl_description()};
  if (must_be_measured(read.protocol.window.face_quality, watched)) {
    face.full_picture = measure_full_picture(*look);
  }
  return face;
}

ChosenQuality quality_of(const SessionFace& face,
                         const protocols::Protocol& protocol,
                         Hertz drawing_rate) {
  std::optional<DrawingPace> pace;
  if (face.full_picture) {
    pace = DrawingPace{
        .picture = *face.full_picture,
        .picture_rate = std::min(drawing_rate, face.look.frame_rate.value_or(drawing_rate)),
        .between_trials = protocol.intervals.pause};
  }
  return choose_quality(protocol.window.face_quality, pace);
}

FaceDrawingRecord record_of(const SessionFace& face, const ChosenQuality& chosen) {
  return {.quality = std::string{name(chosen.quality)},
          .basis = std::string{name(chosen.basis)},
          .full_picture = face.full_picture,
          .renderer = face.renderer};
}

}  // namespace bimodal::runner
