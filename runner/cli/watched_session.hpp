#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "protocols/design/plan.hpp"
#include "protocols/model/protocol.hpp"
#include "runner/booth/overseer.hpp"
#include "runner/cli/resumption.hpp"
#include "runner/devices/clock.hpp"
#include "runner/devices/local/line_server.hpp"
#include "runner/monitor/session_chronicle.hpp"
#include "runner/store/records.hpp"

namespace bimodal::runner {

/// Where the sockets of watched sessions are: beside the data file, with this ending.
inline constexpr const char* kMonitorSocket = ".monitor";

/// What `bimodal monitor` connects to: tells a session's progress on a local socket, and takes
/// requests from it.
class WatchedSession final : public Overseer {
 public:
  /// Opens the socket of the data file. Where there can be none, says so on standard error: the
  /// session is then not watched, and runs all the same. `session` without what is known only when
  /// it begins; `earlier`: the part of it that was before; `clock` is borrowed.
  WatchedSession(const std::filesystem::path& data,
                 const SessionRecord& session,
                 const protocols::Protocol& protocol,
                 const std::vector<protocols::PlannedTrial>& plan,
                 const std::optional<Resumption>& earlier,
                 const Clock& clock);

  /// The session as it is stored, when it begins.
  void begin(const SessionRecord& session);

  void tell(const Progress& progress) override;
  [[nodiscard]] std::optional<Request> request() override;

 private:
  void publish(const StatusLine& line);

  const Clock& clock_;
  SessionChronicle chronicle_;
  std::unique_ptr<LineServer> server_;  ///< null: not watched
};

}  // namespace bimodal::runner
