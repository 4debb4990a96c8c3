#include "runner/devices/right_of_way.hpp"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <sched.h>

#include "runner/realtime/urgency.hpp"

namespace bimodal::runner {

namespace {

constexpr int kPriority = static_cast<int>(Urgency::Presenting);

}  // namespace

RightOfWay::RightOfWay() : granted_{make_urgent(Urgency::Presenting)} {
  description_ = granted_ ? fmt::format("presented at real-time priority {}", kPriority)
                          : fmt::format(
                                "presented at ordinary priority: a real-time one was refused "
                                "({}); see `ulimit -r`",
                                std::strerror(errno));
}

void RightOfWay::keep_to_itself() const noexcept {
  if (!granted_) return;
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  ::sched_setscheduler(0, SCHED_RR | SCHED_RESET_ON_FORK, &parameters);
}

}  // namespace bimodal::runner
