#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "protocols/model/face.hpp"
#include "synth/render/appearance.hpp"
#include "synth/render/view.hpp"
#include "synth/speech/control.hpp"
#include "synth/speech/expression.hpp"

namespace bimodal::runner {

inline constexpr double kWholeHead = 312.0;  ///< mm; crown to neck, as high as the picture

/// How a face holds itself while it speaks.
struct Bearing {
  std::vector<std::pair<synth::Control, double>> controls;  ///< that stay where they are put
  std::vector<synth::ShownExpression> expressions;          ///< on top of speech

  /// What speech makes of the face, in this bearing.
  [[nodiscard]] synth::Pose of(synth::Pose speech) const;
};

/// Names that the face does not know are left out: protocols are judged when they are read.
[[nodiscard]] Bearing bearing_of(const protocols::Face& face);

/// The parts that are drawn.
[[nodiscard]] synth::PartSet shown_parts(const protocols::Face& face);

/// What of the head is drawn, and how. Throws Error if the materials cannot be read.
[[nodiscard]] synth::Appearance appearance_of(const protocols::Face& face, synth::Quality quality);

/// The file of a preset; a file's own name.
[[nodiscard]] std::filesystem::path material_file(const std::string& material);

/// From where it is drawn, `lines` pixels high and 8/9 as wide, before `background` (0xRRGGBB).
[[nodiscard]] synth::View view_of(const protocols::Face& face,
                                  std::size_t lines,
                                  std::uint32_t background);

/// The face but for its bearing: faces that are equal in it are drawn by the same renderer.
[[nodiscard]] protocols::Face at_rest(protocols::Face face);

/// Everything of it as one line of JSON, for data files and the names of films: what is left to
/// defaults, the parts that are seen whole, and the SHA-256 of the materials' file, of whose path
/// only the last part is told. Throws Error as appearance_of().
[[nodiscard]] std::string face_record(const protocols::Face& face);

}  // namespace bimodal::runner
