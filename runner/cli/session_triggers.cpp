#include "runner/cli/session_triggers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runner/devices/local/socket_port.hpp"
#include "runner/devices/serial/serial_port.hpp"
#include "stimuli/base/json_lines.hpp"

namespace bimodal::runner {

std::vector<std::unique_ptr<TriggerSender>> open_trigger_lines(
    const protocols::Triggers& triggers) {
  std::vector<std::unique_ptr<TriggerSender>> lines;
  if (const auto& serial = triggers.serial) {
    lines.push_back(
        std::make_unique<TriggerSender>(std::make_unique<SerialPort>(SerialPort::Options{
            .port = serial->port, .baud = serial->baud, .reset_after = serial->reset_after})));
  }
  if (const auto& socket = triggers.socket) {
    lines.push_back(std::make_unique<TriggerSender>(std::make_unique<SocketPort>(socket->path)));
  }
  return lines;
}

std::vector<TriggerLine*> borrowed(const std::vector<std::unique_ptr<TriggerSender>>& lines) {
  std::vector<TriggerLine*> pointers;
  for (const auto& line : lines) pointers.push_back(line.get());
  return pointers;
}

std::string trigger_kinds(const protocols::Triggers& triggers) {
  std::vector<std::string_view> kinds;
  if (triggers.photodiode) kinds.emplace_back("photodiode");
  if (triggers.click) kinds.emplace_back("click");
  if (triggers.serial) kinds.emplace_back("serial");
  if (triggers.socket) kinds.emplace_back("socket");
  return fmt::format("{}", fmt::join(kinds, ", "));
}

std::vector<Diagnostic> check_trigger_equipment(const protocols::ReadProtocol& read,
                                                const std::string& file) {
  std::vector<Diagnostic> found;
  const auto& serial = read.protocol.triggers.serial;
  if (!serial || std::filesystem::exists(serial->port)) return found;
  const JsonLines lines{read.text};
  const std::string pointer = "/triggers/serial/port";
  found.push_back({.severity = Severity::Warning,
                   .file = file,
                   .line = lines.line_of(pointer),
                   .pointer = pointer,
                   .finding = fmt::format("there is no port '{}' here now", serial->port),
                   .remedy = "connect it before `run`, or see `bimodal devices` for the ports "
                             "that there are"});
  return found;
}

}  // namespace bimodal::runner
