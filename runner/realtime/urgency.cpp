#include "runner/realtime/urgency.hpp"

#include <sched.h>
#include <sys/prctl.h>

namespace bimodal::runner {

bool make_urgent(Urgency urgency) noexcept {
  constexpr unsigned long kOneNanosecond = 1;
  prctl(PR_SET_TIMERSLACK, kOneNanosecond);
  sched_param parameters{};
  parameters.sched_priority = static_cast<int>(urgency);
  constexpr int kThisThread = 0;
  return ::sched_setscheduler(kThisThread, SCHED_RR, &parameters) == 0;
}

}  // namespace bimodal::runner
