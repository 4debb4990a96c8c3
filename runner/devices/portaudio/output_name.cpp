#include "runner/devices/portaudio/output_name.hpp"

#include <fmt/format.h>

namespace bimodal::runner {

std::string lasting_name(const AudioDevice& device) {
  return fmt::format("{} ({})", device.name, device.host);
}

std::string output_name(const std::string& wanted) {
  const PortaudioSession session;
  return lasting_name(choose_device(session.devices(), wanted));
}

}  // namespace bimodal::runner
