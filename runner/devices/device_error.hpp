#pragma once

#include "stimuli/base/error.hpp"

namespace bimodal::runner {

/// A device is missing or was lost; the message says which, and what to do instead (exit code 4).
class DeviceError : public Error {
 public:
  using Error::Error;
};

/// The screen has gone in the middle of a session.
class DisplayLost : public DeviceError {
 public:
  using DeviceError::DeviceError;
};

/// The sound output has gone in the middle of a session. It may come back.
class SoundLost : public DeviceError {
 public:
  using DeviceError::DeviceError;
};

}  // namespace bimodal::runner
