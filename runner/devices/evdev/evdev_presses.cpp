#include "runner/devices/evdev/evdev_presses.hpp"

#include <cerrno>
#include <chrono>
#include <climits>
#include <ctime>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace bimodal::runner {
namespace {

constexpr int kDown = 1;  ///< value of a key that goes down; 0: up, 2: repeated

bool has_keys(int device) {
  unsigned long types = 0;
  static_assert(EV_CNT <= sizeof(types) * CHAR_BIT);
  return ioctl(device, EVIOCGBIT(0, sizeof(types)), &types) >= 0 && ((types >> EV_KEY) & 1U) != 0;
}

bool stamps_by_session_clock(int device) {
  int clock = CLOCK_MONOTONIC;
  return ioctl(device, EVIOCSCLOCKID, &clock) == 0;
}

/// Else a fast mouse would fill the kernel's buffer between two calls. (Kernels before 4.4 cannot.)
void ask_for_keys_only(int device) {
  constexpr unsigned kTypes = (1U << EV_SYN) | (1U << EV_KEY);
  unsigned types = kTypes;
  const input_mask mask{.type = EV_SYN,
                        .codes_size = sizeof(types),
                        .codes_ptr = reinterpret_cast<std::uintptr_t>(&types)};
  static_cast<void>(ioctl(device, EVIOCSMASK, &mask));
}

Instant instant_of(const input_event& event) {
  return Instant{std::chrono::seconds{event.input_event_sec} +
                 std::chrono::microseconds{event.input_event_usec}};
}

}  // namespace

EvdevPresses::EvdevPresses(const std::filesystem::path& folder) {
  int refused = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator{folder, error}) {
    if (descriptors_.size() == kMostDevices) break;
    if (!entry.path().filename().native().starts_with("event")) continue;
    const int device = open(entry.path().c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (device < 0) {
      ++refused;
    } else if (has_keys(device) && stamps_by_session_clock(device)) {
      ask_for_keys_only(device);
      descriptors_.push_back(device);
    } else {
      close(device);
    }
  }
  if (!descriptors_.empty()) return;
  refusal_ = refused > 0 ? fmt::format("{} input devices may not be read (group input)", refused)
                         : fmt::format("no input devices in {}", folder.native());
}

EvdevPresses::EvdevPresses(std::vector<int> descriptors) : descriptors_{std::move(descriptors)} {
  if (descriptors_.empty()) refusal_ = "no input devices";
}

EvdevPresses::~EvdevPresses() {
  for (const int device : descriptors_) close(device);
}

std::span<const KernelPress> EvdevPresses::collect() {
  count_ = 0;
  std::erase_if(descriptors_, [this](int device) {
    const bool lost = !read_from(device);
    if (lost) close(device);
    return lost;
  });
  return std::span{presses_}.first(count_);
}

/// False: the device is gone.
bool EvdevPresses::read_from(int descriptor) {
  while (count_ < kMostPresses) {
    std::array<input_event, kMostPresses> events{};
    const auto wanted = (kMostPresses - count_) * sizeof(input_event);
    const auto got = read(descriptor, events.data(), wanted);
    if (got == 0) return false;
    if (got < 0) return errno == EAGAIN || errno == EINTR;
    const auto whole = static_cast<std::size_t>(got) / sizeof(input_event);
    for (const auto& event : std::span{events}.first(whole)) {
      if (event.type != EV_KEY || event.value != kDown) continue;
      presses_[count_++] = {.code = event.code, .at = instant_of(event)};
    }
    if (static_cast<std::size_t>(got) < wanted) return true;
  }
  return true;
}

}  // namespace bimodal::runner
