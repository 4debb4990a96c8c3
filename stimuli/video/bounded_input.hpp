#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

extern "C" {
#include <libavformat/avio.h>
}

namespace bimodal::libav {

/// A file as FFmpeg reads it: by descriptor, so that its name is never taken for a URL or a
/// pattern, and only so many bytes altogether, so that a demuxer led in circles by a damaged file
/// comes to an end.
class BoundedInput {
 public:
  /// Throws Error, naming the file, if it is missing, no ordinary file, empty or unreadable.
  explicit BoundedInput(const std::filesystem::path& file);
  ~BoundedInput();
  BoundedInput(const BoundedInput&) = delete;
  BoundedInput& operator=(const BoundedInput&) = delete;
  BoundedInput(BoundedInput&&) = delete;
  BoundedInput& operator=(BoundedInput&&) = delete;

  [[nodiscard]] AVIOContext* context() const { return context_; }

  [[nodiscard]] std::int64_t size() const { return size_; }

 private:
  static int read(void* self, std::uint8_t* buffer, int most);
  static std::int64_t seek(void* self, std::int64_t offset, int from);

  int descriptor_ = -1;
  std::int64_t size_ = 0;
  std::int64_t budget_ = 0;
  AVIOContext* context_ = nullptr;
};

}  // namespace bimodal::libav
