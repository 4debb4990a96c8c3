#pragma once

#include <filesystem>

#include "runner/devices/local/line_server.hpp"
#include "runner/devices/triggers/trigger_port.hpp"

namespace bimodal::runner {

/// Tells events to every program of this user that is connected to a local socket, each in a line
/// of JSON: {"event":"visual_zero","trial":0,"condition":"AV","planned_ns":...,"sent_ns":...}.
/// Nobody need listen; who connects later does not hear of what was before.
class SocketPort final : public TriggerPort {
 public:
  /// Listens at `path`. Throws DeviceError as LineServer does.
  explicit SocketPort(const std::filesystem::path& path) : path_{path}, server_{path} {}

  [[nodiscard]] bool send(const TriggerSignal& signal, Instant now) override;

  [[nodiscard]] std::string_view kind() const override { return "socket"; }

  [[nodiscard]] std::string description() const override { return "socket " + path_.string(); }

 private:
  std::filesystem::path path_;
  LineServer server_;
};

}  // namespace bimodal::runner
