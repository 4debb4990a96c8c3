#include "stimuli/base/written_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include "stimuli/base/error.hpp"

namespace bimodal {

void write_file(const std::filesystem::path& file, std::string_view bytes) {
  auto beside = file;
  beside += fmt::format(".{}.part", ::getpid());
  const auto refuse = [&](const std::string& reason) {
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    return Error{
        fmt::format("cannot write '{}': {}; check that its folder exists, may be written "
                    "to and has room",
                    file.string(),
                    reason)};
  };
  std::ofstream out{beside, std::ios::binary | std::ios::trunc};
  if (!out) throw refuse(std::strerror(errno));
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw refuse(std::strerror(errno));
  std::error_code failure;
  std::filesystem::rename(beside, file, failure);
  if (failure) throw refuse(failure.message());
}

}  // namespace bimodal
