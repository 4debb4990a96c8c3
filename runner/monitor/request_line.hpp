#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "runner/session/progress.hpp"

namespace bimodal::runner {

/// What is wrong with a line, for its sender.
struct LineFault {
  std::string finding;
};

/// `{"ask":"pause"}`, "resume" or "stop". Takes any bytes: they come from another program.
[[nodiscard]] std::variant<Request, LineFault> read_request(std::string_view line);

/// The line that asks for it.
[[nodiscard]] std::string request_line(Request request);

/// "pause", "resume", "stop".
[[nodiscard]] std::string_view name(Request request);

/// The answers to a line: it was taken, or not.
[[nodiscard]] std::string taken_line(Request request);
[[nodiscard]] std::string error_line(const LineFault& fault);

}  // namespace bimodal::runner
