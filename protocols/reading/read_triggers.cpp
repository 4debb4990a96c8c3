#include "protocols/reading/read_triggers.hpp"

#include <utility>

#include "protocols/model/protocol.hpp"

namespace bimodal::protocols {

namespace {

using namespace std::chrono_literals;

constexpr std::array<std::string_view, 4> kCorners{
    "upper-left", "upper-right", "lower-left", "lower-right"};
constexpr std::array<std::string_view, 2> kPolarities{"white-on-black", "black-on-white"};
constexpr NumberRule kPart{0, 1, "a part of the window, 0 to 1, e.g. 0.9"};

/// The path of a Unix socket is at most so long, in bytes.
constexpr std::size_t kLongestSocketPath = 107;

template <typename T>
void take(T& target, std::optional<T> read) {
  if (read) target = std::move(*read);
}

void take_whole(int& target, std::optional<std::int64_t> read) {
  if (read) target = static_cast<int>(*read);
}

void read_place(ObjectReader& reader, Photodiode& patch, Findings& findings) {
  if (const auto corner = reader.choice("corner", kCorners)) {
    patch.corner = static_cast<Corner>(*corner);
  }
  if (!reader.has("centre")) return;
  if (reader.has("corner")) {
    findings.error(reader.pointer_to("centre"),
                   "the patch cannot be in a corner and have its middle elsewhere",
                   "write \"corner\" or \"centre\"");
  }
  const auto parts = reader.items("centre", 2, 2);
  if (parts.empty()) return;
  const auto x = reader.number_of(*parts[0].first, parts[0].second, kPart);
  const auto y = reader.number_of(*parts[1].first, parts[1].second, kPart);
  if (x && y) patch.centre = {*x, *y};
}

std::optional<Photodiode> read_photodiode(ObjectReader& parent, Findings& findings) {
  auto reader = parent.object("photodiode");
  if (!reader) return std::nullopt;
  Photodiode patch;
  read_place(*reader, patch, findings);
  take_whole(patch.size, reader->whole("size_px", {4, 4'096, "a number of pixels, e.g. 60"}));
  if (const auto polarity = reader->choice("polarity", kPolarities)) {
    patch.polarity = static_cast<Polarity>(*polarity);
  }
  take(patch.length,
       reader->time("length_ms", 1ms, {1, 10'000, "a time in milliseconds, e.g. 100"}));
  reader->refuse_unknown_keys();
  return patch;
}

std::optional<Click> read_click(ObjectReader& parent) {
  auto reader = parent.object("click");
  if (!reader) return std::nullopt;
  Click click;
  reader->require("channel", "a channel of the output that carries nothing else, e.g. 3");
  take_whole(click.channel,
             reader->whole("channel", {1, kMostChannels, "a channel of the output, from 1"}));
  take(click.length, reader->time("length_ms", 1ms, {0.1, 100, "a time in milliseconds, e.g. 1"}));
  take(click.amplitude,
       reader->number("amplitude", {0.001, 1, "a part of full scale, up to 1, e.g. 0.5"}));
  reader->refuse_unknown_keys();
  return click;
}

void read_codes(ObjectReader& parent, SerialTriggers& serial, Findings& findings) {
  auto reader = parent.object("codes");
  if (!reader) return;
  bool any = false;
  for (std::size_t event = 0; event < kTriggerEvents.size(); ++event) {
    any = any || reader->has(kTriggerEvents[event]);
    const auto code =
        reader->whole(kTriggerEvents[event], {1, 255, "the byte that is sent, 1 to 255"});
    if (code) serial.codes[event] = static_cast<int>(*code);
  }
  reader->refuse_unknown_keys();
  if (any || findings.faulty(reader->pointer())) return;
  findings.error(reader->pointer(), "no event has a code", "give e.g. { \"visual_zero\": 1 }");
}

std::optional<SerialTriggers> read_serial(ObjectReader& parent, Findings& findings) {
  auto reader = parent.object("serial");
  if (!reader) return std::nullopt;
  SerialTriggers serial;
  constexpr std::string_view kPort = "the port, e.g. \"/dev/ttyUSB0\"";
  reader->require("port", kPort);
  take(serial.port, reader->text("port", {.shortest = 1, .longest = 500, .meaning = kPort}));
  take_whole(serial.baud, reader->whole("baud", {50, 4'000'000, "bits per second, e.g. 115200"}));
  reader->require("codes", "{ \"visual_zero\": 1 }");
  read_codes(*reader, serial, findings);
  serial.reset_after =
      reader->time("reset_after_ms", 1ms, {1, 1'000, "a time in milliseconds, e.g. 10"});
  reader->refuse_unknown_keys();
  return serial;
}

std::optional<SocketTriggers> read_socket(ObjectReader& parent, Findings& findings) {
  auto reader = parent.object("socket");
  if (!reader) return std::nullopt;
  SocketTriggers socket;
  constexpr std::string_view kPath = "the path of a socket, e.g. \"triggers.socket\"";
  reader->require("path", kPath);
  take(socket.path,
       reader->text("path", {.shortest = 1, .longest = kLongestSocketPath, .meaning = kPath}));
  if (socket.path.size() > kLongestSocketPath) {
    findings.error(reader->pointer_to("path"),
                   "a path of more than 107 bytes cannot be that of a socket",
                   "choose a shorter one");
  }
  reader->refuse_unknown_keys();
  return socket;
}

}  // namespace

Triggers read_triggers(ObjectReader& parent, Findings& findings) {
  auto reader = parent.object("triggers");
  if (!reader) return {};
  Triggers triggers{.photodiode = read_photodiode(*reader, findings),
                    .click = read_click(*reader),
                    .serial = read_serial(*reader, findings),
                    .socket = read_socket(*reader, findings)};
  reader->refuse_unknown_keys();
  return triggers;
}

}  // namespace bimodal::protocols
