#pragma once

#include <memory>
#include <string>
#include <vector>

#include "protocols/reading/read_protocol.hpp"
#include "runner/devices/triggers/trigger_sender.hpp"

namespace bimodal::runner {

/// The lines to other equipment that a protocol asks for. Throws DeviceError, naming the way out,
/// if one cannot be opened.
[[nodiscard]] std::vector<std::unique_ptr<TriggerSender>> open_trigger_lines(
    const protocols::Triggers& triggers);

/// As the session loop borrows them.
[[nodiscard]] std::vector<TriggerLine*> borrowed(
    const std::vector<std::unique_ptr<TriggerSender>>& lines);

/// The kinds of triggers that a protocol asks for: "photodiode, serial"; empty: none.
[[nodiscard]] std::string trigger_kinds(const protocols::Triggers& triggers);

/// Warns of ports and sockets that cannot be used on this machine now. `file` names the protocol.
[[nodiscard]] std::vector<Diagnostic> check_trigger_equipment(const protocols::ReadProtocol& read,
                                                              const std::string& file);

}  // namespace bimodal::runner
