#include "stimuli/base/obstacle.hpp"

#include <system_error>

#include <fmt/format.h>

#include "stimuli/base/json_text.hpp"

namespace bimodal {

std::optional<std::string> obstacle(const std::filesystem::path& file) {
  using std::filesystem::file_type;
  std::error_code fault;
  const auto type = std::filesystem::status(file, fault).type();
  if (type == file_type::not_found) return "there is no such file";
  if (fault) return fault.message();
  if (type == file_type::directory) return "it is a folder";
  if (type != file_type::regular) return "it is not an ordinary file";
  const auto size = std::filesystem::file_size(file, fault);
  if (fault) return fault.message();
  if (size > kLargestFile) {
    return fmt::format("{} bytes are more than the {} MB that we read", size, kLargestFile >> 20U);
  }
  return std::nullopt;
}

}  // namespace bimodal
