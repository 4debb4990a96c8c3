#include "runner/monitor/request_line.hpp"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "stimuli/base/json_text.hpp"

namespace bimodal::runner {

namespace {

constexpr std::array kRequests{Request::Pause, Request::Resume, Request::Stop};
constexpr std::size_t kMostValues = 16;

}  // namespace

std::string_view name(Request request) {
  switch (request) {
    case Request::Pause:
      return "pause";
    case Request::Resume:
      return "resume";
    case Request::Stop:
      return "stop";
  }
  return "";
}

std::variant<Request, LineFault> read_request(std::string_view line) {
  const auto parsed = parse_json(line, kMostValues);
  if (const auto* const fault = std::get_if<TextFault>(&parsed)) {
    return LineFault{"a request is JSON: " + fault->finding};
  }
  const auto& value = std::get<nlohmann::json>(parsed);
  const auto ask = value.is_object() ? value.find("ask") : value.end();
  if (ask != value.end() && ask->is_string()) {
    const auto& asked = ask->get_ref<const std::string&>();
    const auto* const known =
        std::ranges::find_if(kRequests, [&](Request request) { return name(request) == asked; });
    if (known != kRequests.end()) return *known;
  }
  return LineFault{R"(a request is {"ask":"pause"}, {"ask":"resume"} or {"ask":"stop"})"};
}

std::string request_line(Request request) {
  return nlohmann::json{{"ask", name(request)}}.dump();
}

std::string taken_line(Request request) {
  return nlohmann::ordered_json{{"kind", "taken"}, {"ask", name(request)}}.dump();
}

std::string error_line(const LineFault& fault) {
  return nlohmann::ordered_json{{"kind", "error"}, {"text", fault.finding}}.dump(
      -1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace bimodal::runner
