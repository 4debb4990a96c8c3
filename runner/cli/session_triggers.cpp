#include "runner/cli/session_triggers.hpp"

#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "runner/devices/local/socket_port.hpp"
#include "runner/devices/serial/serial_port.hpp"
#include "stimuli/base/json_lines.hpp"

namespace bimodal::runner {

namespace {

template <typename Warn>
void judge_port(const std::string& port, const Warn& warn) {
  constexpr const char* kPointer = "/triggers/serial/port";
  std::error_code fault;  // of a folder, say, that may not be searched
  const auto kind = std::filesystem::status(port, fault).type();
  if (kind == std::filesystem::file_type::not_found) {
    warn(kPointer,
         fmt::format("there is no port '{}' here now", port),
         "connect it before `run`, or see `bimodal devices` for the ports that there are");
  } else if (::access(port.c_str(), R_OK | W_OK) != 0) {
    warn(kPointer,
         fmt::format("you may not use the port '{}'", port),
         "become a member of its group (on Debian: dialout) and log in again");
  } else if (kind != std::filesystem::file_type::character) {
    warn(kPointer,
         fmt::format("'{}' is no port", port),
         "see `bimodal devices` for the ports that there are");
  }
}

template <typename Warn>
void judge_socket(const std::string& path, const Warn& warn) {
  constexpr const char* kPointer = "/triggers/socket/path";
  auto folder = std::filesystem::path{path}.parent_path();
  if (folder.empty()) folder = ".";
  std::error_code fault;
  const auto kind = std::filesystem::status(folder, fault).type();
  if (kind == std::filesystem::file_type::not_found) {
    warn(kPointer,
         fmt::format("there is no folder '{}' here for the socket", folder.string()),
         "make it before `run`, or choose another path");
  } else if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    warn(kPointer,
         fmt::format("you may not make a socket in the folder '{}'", folder.string()),
         "choose another path");
  } else if (std::filesystem::exists(path, fault) && !std::filesystem::is_socket(path, fault)) {
    warn(kPointer,
         fmt::format("'{}' is there already, and is no socket", path),
         "move it away, or choose another path");
  }
}

}  // namespace

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
  const auto warn = [&](const std::string& pointer, std::string finding, const char* remedy) {
    found.push_back({.severity = Severity::Warning,
                     .file = file,
                     .line = JsonLines{read.text}.line_of(pointer),
                     .pointer = pointer,
                     .finding = std::move(finding),
                     .remedy = remedy});
  };
  const auto& triggers = read.protocol.triggers;
  if (triggers.serial) judge_port(triggers.serial->port, warn);
  if (triggers.socket) judge_socket(triggers.socket->path, warn);
  return found;
}

}  // namespace bimodal::runner
