#pragma once

namespace bimodal::runner {

/// Which threads come before which, and all of them before ordinary programs: their real-time
/// priorities (SCHED_RR). Sound servers have higher ones.
enum class Urgency : int { Storing = 4, Presenting = 5 };

/// Gives the calling thread that urgency, and lets its sleeps end when they should (timer slack of
/// 1 ns). False if the system does not allow it (needs root or a real-time limit): it then stays an
/// ordinary thread, and errno tells why.
bool make_urgent(Urgency urgency) noexcept;

}  // namespace bimodal::runner
