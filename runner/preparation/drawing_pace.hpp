#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocols/design/plan.hpp"
#include "runner/preparation/shown_look.hpp"

namespace bimodal::runner {

/// The look of the synthetic face that takes longest to draw in the trials of `plan`: the most
/// pixels a second, and among equals skin that is seen through, then the most parts. Absent if they
/// show none. Throws Error as nature_of().
[[nodiscard]] std::optional<ShownLook> costliest_face(
    const protocols::Protocol& protocol,
    const std::vector<protocols::PlannedTrial>& plan,
    const std::map<std::string, Corpus>& corpora);

/// How long one picture of a speaking face takes in full quality, made ready for the screen: the
/// median of a few, measured now. Throws Error if it cannot be drawn.
[[nodiscard]] Duration measure_full_picture(const ShownLook& look);

}  // namespace bimodal::runner
