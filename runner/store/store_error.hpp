#pragma once

#include "stimuli/base/error.hpp"

namespace bimodal::runner {

/// Data cannot be kept or read: the disk is full, the folder read-only, the file newer than the
/// program. A session stops rather than go on without a store (exit code 5).
class StoreError : public Error {
 public:
  using Error::Error;
};

}  // namespace bimodal::runner
