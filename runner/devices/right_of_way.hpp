#pragma once

#include <string>

namespace bimodal::runner {

/// The right of way of the presenting thread before all ordinary programs (SCHED_RR, priority 5:
/// below sound servers), so that no refresh is missed because the machine does something else.
/// Threads that it starts while drawing is set up have it too (those of an OpenGL that draws by
/// software); after keep_to_itself() new threads are ordinary ones. Needs root or a real-time limit
/// (`ulimit -r`; on Debian a line "@audio - rtprio 95" in /etc/security/limits.d).
class RightOfWay {
 public:
  /// Asks for it for the calling thread.
  RightOfWay();

  void keep_to_itself() const noexcept;

  /// What came of it, for the record: "presented at real-time priority 5", or why not.
  [[nodiscard]] const std::string& description() const { return description_; }

 private:
  bool granted_ = false;
  std::string description_;
};

}  // namespace bimodal::runner
