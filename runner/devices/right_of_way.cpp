#include "runner/devices/right_of_way.hpp"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <sched.h>

namespace bimodal::runner {

namespace {

constexpr int kPriority = 5;

bool set(int policy) noexcept {
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  return ::sched_setscheduler(0, policy, &parameters) == 0;
}

}  // namespace

RightOfWay::RightOfWay() : granted_{set(SCHED_RR)} {
  description_ = granted_ ? fmt::format("presented at real-time priority {}", kPriority)
                          : fmt::format(
                                "presented at ordinary priority: a real-time one was refused "
                                "({}); see `ulimit -r`",
                                std::strerror(errno));
}

void RightOfWay::keep_to_itself() const noexcept {
  if (granted_) static_cast<void>(set(SCHED_RR | SCHED_RESET_ON_FORK));
}

}  // namespace bimodal::runner
