#include "runner/devices/local/socket_places.hpp"

#include <cstdlib>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "runner/devices/local/local_socket.hpp"
#include "stimuli/base/digest.hpp"

namespace bimodal::runner {

std::vector<std::filesystem::path> socket_places(const std::filesystem::path& data,
                                                 std::string_view suffix) {
  std::error_code failure;
  auto absolute = std::filesystem::weakly_canonical(data, failure);
  if (failure) absolute = std::filesystem::absolute(data);
  constexpr std::size_t kDigits = 24;
  const auto digest = sha256(absolute.native()).substr(0, kDigits);
  const auto name = fmt::format("bimodal-{}-{}{}", ::geteuid(), digest, suffix);
  std::vector<std::filesystem::path> places{absolute.native() + std::string{suffix}};
  const char* const runtime = std::getenv("XDG_RUNTIME_DIR");
  if (runtime != nullptr && *runtime == '/') {
    places.push_back(std::filesystem::path{runtime} / name);
  }
  places.push_back(std::filesystem::path{"/tmp"} / name);
  std::erase_if(places, [](const auto& place) { return !fits_socket(place); });
  return places;
}

}  // namespace bimodal::runner
