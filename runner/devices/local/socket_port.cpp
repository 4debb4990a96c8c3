#include "runner/devices/local/socket_port.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bimodal::runner {

bool SocketPort::send(const TriggerSignal& signal, Instant now) {
  const auto line =
      fmt::format(R"({{"event":"{}","trial":{},"condition":{},"planned_ns":{},"sent_ns":{}}})",
                  signal.event,
                  signal.trial,
                  nlohmann::json(signal.condition).dump(),
                  signal.planned.time_since_epoch().count(),
                  now.time_since_epoch().count());
  return server_.publish("", line);
}

}  // namespace bimodal::runner
