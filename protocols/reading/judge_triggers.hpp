#pragma once

#include "protocols/model/protocol.hpp"
#include "stimuli/base/findings.hpp"

namespace bimodal::protocols {

/// Whether triggers fit the rest of the protocol: a channel of their own for clicks, a patch that
/// lies within the window, something to be heard where clicks are asked for. What is faulty by
/// itself is not judged again.
void judge_triggers(const Protocol& protocol, Findings& findings);

}  // namespace bimodal::protocols
