#include "runner/realtime/urgency.hpp"

#include <sched.h>
#include <sys/prctl.h>

namespace bimodal::runner {

bool make_urgent(Urgency urgency) noexcept {
  constexpr unsigned long kOneNanosecond = 1;
  prctl(PR_SET_TIMERSLACK, kOneNanosecond);
  sched_param parameters{};
  parameters.sched_priority = static_cast<int>(urgency);
  const auto set = [&parameters](int policy) {
    constexpr int kThisThread = 0;
    return ::sched_setscheduler(kThisThread, policy, &parameters) == 0;
  };
  // A thread that has once kept it from its children may not give it to them again.
  return set(SCHED_RR) || set(SCHED_RR | SCHED_RESET_ON_FORK);
}

}  // namespace bimodal::runner
