#pragma once

#include <string_view>
#include <vector>

#include "synth/render/view.hpp"

namespace bimodal::runner {

/// The views of the face that have a name, in protocols and on the command line: "front",
/// "threequarter", "side" (both from the subject's left), "mouth" (from the front, near).
[[nodiscard]] std::vector<std::string_view> view_names();

/// Whether the whole head is in the picture.
[[nodiscard]] bool shows_whole_head(std::string_view name);

/// Sets what the name means, direction and part of the head, and leaves the rest alone. Throws
/// Error for a name that is none of view_names().
void take_view(std::string_view name, synth::View& view);

}  // namespace bimodal::runner
