#pragma once

#include "protocols/model/protocol.hpp"
#include "stimuli/base/findings.hpp"

namespace bimodal::protocols {

/// Whether the rules of timing have something to rule: warns of a line of the screen where nobody
/// is seen. What is faulty by itself is not judged again.
void judge_timing(const Protocol& protocol, Findings& findings);

}  // namespace bimodal::protocols
