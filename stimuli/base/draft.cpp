#include "stimuli/base/draft.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& target, const std::string& finding) {
  throw Error{fmt::format("cannot write '{}': {}; check the folder, its permissions and free space",
                          target.string(),
                          finding)};
}

std::error_code last_error() {
  return {errno, std::generic_category()};
}

/// Waits until the content of a file is on the disk.
std::error_code sync(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return last_error();
  const auto outcome = ::fsync(descriptor) == 0 ? std::error_code{} : last_error();
  ::close(descriptor);
  return outcome;
}

}  // namespace

Draft::Draft(const std::filesystem::path& target)
    : path_{target.string() + fmt::format(".{}.part", ::getpid())}, target_{target} {}

Draft::~Draft() {
  std::error_code ignored;
  if (!kept_) std::filesystem::remove(path_, ignored);
}

void Draft::keep(Durability durability) {
  std::error_code failure;
  if (durability == Durability::AtOnce) failure = sync(path_);
  if (!failure) std::filesystem::rename(path_, target_, failure);
  if (failure) refuse(target_, failure.message());
  kept_ = true;
}

void write_file(const std::filesystem::path& file,
                std::string_view content,
                Durability durability) {
  Draft draft{file};
  std::ofstream stream{draft.path(), std::ios::binary};
  if (!stream) refuse(file, last_error().message());
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) refuse(file, "not all of it could be written");
  draft.keep(durability);
}

}  // namespace bimodal
