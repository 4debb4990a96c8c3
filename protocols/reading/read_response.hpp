#pragma once

#include "protocols/model/response.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/base/object_reader.hpp"

namespace bimodal::protocols {

/// Reads the key "response" of `parent`, and notes every mistake. What it leaves out has its
/// default.
[[nodiscard]] Response read_response(ObjectReader& parent, Findings& findings);

}  // namespace bimodal::protocols
