#pragma once

#include <optional>

#include "runner/session/progress.hpp"

namespace bimodal::runner {

/// Somebody outside who watches a session and may ask for something. Called by the session's
/// thread; must never make it wait.
class Overseer {
 public:
  Overseer() = default;
  Overseer(const Overseer&) = delete;
  Overseer& operator=(const Overseer&) = delete;
  Overseer(Overseer&&) = delete;
  Overseer& operator=(Overseer&&) = delete;
  virtual ~Overseer() = default;

  /// Never called while a stimulus is on.
  virtual void tell(const Progress& progress) = 0;

  /// The oldest request that has not been taken yet. Nothing: there is none at the moment; asked
  /// again at every refresh.
  [[nodiscard]] virtual std::optional<Request> request() = 0;
};

}  // namespace bimodal::runner
