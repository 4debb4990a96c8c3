#include "stimuli/video/bounded_input.hpp"

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

extern "C" {
#include <libavutil/mem.h>
}

#include "stimuli/video/libav.hpp"

namespace bimodal::libav {

namespace {

constexpr int kBuffer = 64 * 1024;
/// A recording whose sound and picture lie far apart is read in small pieces, each filling the
/// buffer: many times the file's size is still honest.
constexpr std::int64_t kReadings = 64;
constexpr std::int64_t kAllowance = 64LL * 1024 * 1024;
/// What one call costs beside its bytes.
constexpr std::int64_t kCallCost = 1024;

}  // namespace

BoundedInput::BoundedInput(const std::filesystem::path& file) {
  constexpr auto kDeed = "read";
  std::error_code failure;
  const auto kind = std::filesystem::status(file, failure).type();
  if (kind == std::filesystem::file_type::not_found) {
    refuse(kDeed, file, "there is no such file", "check its name and folder");
  }
  if (kind == std::filesystem::file_type::directory) {
    refuse(kDeed, file, "it is a folder", "name a file");
  }
  if (kind != std::filesystem::file_type::regular) {
    refuse(kDeed, file, failure ? failure.message() : "it is no ordinary file", "name a recording");
  }
  descriptor_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) {
    refuse(kDeed, file, std::generic_category().message(errno), "check its permissions");
  }
  size_ = std::max<std::int64_t>(::lseek(descriptor_, 0, SEEK_END), 0);
  ::lseek(descriptor_, 0, SEEK_SET);
  if (size_ == 0) {
    ::close(descriptor_);
    refuse(kDeed, file, "it is empty", "copy or record it again");
  }
  budget_ = kReadings * size_ + kAllowance;
  auto* buffer = static_cast<std::uint8_t*>(av_malloc(kBuffer));
  if (buffer != nullptr) {
    context_ = avio_alloc_context(buffer, kBuffer, 0, this, &read, nullptr, &seek);
  }
  if (context_ == nullptr) {
    av_free(buffer);
    ::close(descriptor_);
    throw std::bad_alloc{};
  }
}

BoundedInput::~BoundedInput() {
  av_freep(static_cast<void*>(&context_->buffer));
  avio_context_free(&context_);
  ::close(descriptor_);
}

int BoundedInput::read(void* self, std::uint8_t* buffer, int most) {
  auto& input = *static_cast<BoundedInput*>(self);
  if (input.budget_ < 0) return AVERROR_EXIT;
  const auto got = ::read(input.descriptor_, buffer, static_cast<std::size_t>(std::max(most, 0)));
  if (got < 0) return AVERROR(errno);
  input.budget_ -= got + kCallCost;
  return got == 0 ? AVERROR_EOF : static_cast<int>(got);
}

std::int64_t BoundedInput::seek(void* self, std::int64_t offset, int from) {
  auto& input = *static_cast<BoundedInput*>(self);
  if ((from & AVSEEK_SIZE) != 0) return input.size_;
  input.budget_ -= kCallCost;
  if (input.budget_ < 0) return AVERROR_EXIT;
  const auto reached = ::lseek(input.descriptor_, offset, from & ~AVSEEK_FORCE);
  return reached < 0 ? AVERROR(errno) : reached;
}

}  // namespace bimodal::libav
