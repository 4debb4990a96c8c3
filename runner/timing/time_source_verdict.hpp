#pragma once

#include <string_view>

namespace bimodal::runner {

/// Whether instants that somebody else reports can be believed.
struct TimeSourceVerdict {
  bool plausible = false;
  std::string_view reason;  ///< why not, for the record
};

}  // namespace bimodal::runner
