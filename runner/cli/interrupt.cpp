#include "runner/cli/interrupt.hpp"

#include <atomic>
#include <csignal>

namespace bimodal::runner {

namespace {

std::atomic<bool> asked = false;

}  // namespace

void stop_at_interrupt() {
  struct sigaction action {};

  action.sa_handler = [](int) { asked = true; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaction(signal, &action, nullptr);
}

bool interrupt_asked() {
  return asked.load();
}

}  // namespace bimodal::runner
