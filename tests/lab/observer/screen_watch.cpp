#include "screen_watch.hpp"

#include <cerrno>
#include <stdexcept>
#include <string_view>

#include <poll.h>
#include <sys/mman.h>
#include <unistd.h>

#include "protocols.hpp"

namespace lab {

namespace {

Screencopy& screencopy() {
  static Screencopy tables;
  return tables;
}

}  // namespace

struct ScreenWatch::Connection {
  wl_display* display = nullptr;
  wl_output* output = nullptr;
  wl_shm* shm = nullptr;
  wl_proxy* manager = nullptr;
  wl_buffer* buffer = nullptr;
  const std::uint8_t* pixels = nullptr;
  std::size_t mapped = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t stride = 0;
  Region region;
  int columns = 1;
  bool done = false;
  bool failed = false;
  std::int64_t ready_ns = 0;

  static Connection& from(void* data) { return *static_cast<Connection*>(data); }

  static void on_global(void* data,
                        wl_registry* registry,
                        std::uint32_t name,
                        const char* interface,
                        std::uint32_t /*version*/) {
    auto& self = from(data);
    const std::string_view found{interface};
    if (found == wl_shm_interface.name) {
      self.shm = static_cast<wl_shm*>(wl_registry_bind(registry, name, &wl_shm_interface, 1));
    } else if (found == wl_output_interface.name && self.output == nullptr) {
      self.output =
          static_cast<wl_output*>(wl_registry_bind(registry, name, &wl_output_interface, 1));
    } else if (found == screencopy().manager.name) {
      self.manager =
          static_cast<wl_proxy*>(wl_registry_bind(registry, name, &screencopy().manager, 1));
    }
  }

  static void on_removed(void* /*data*/, wl_registry* /*registry*/, std::uint32_t /*name*/) {}

  static void on_buffer(void* data,
                        wl_proxy* frame,
                        std::uint32_t format,
                        std::uint32_t width,
                        std::uint32_t height,
                        std::uint32_t stride) {
    auto& self = from(data);
    if (self.buffer == nullptr) self.make_buffer(format, width, height, stride);
    wl_proxy_marshal_flags(frame, kCopy, nullptr, 1, 0, self.buffer);
  }

  static void on_flags(void* /*data*/, wl_proxy* /*frame*/, std::uint32_t /*flags*/) {}

  static void on_ready(void* data,
                       wl_proxy* frame,
                       std::uint32_t seconds_high,
                       std::uint32_t seconds_low,
                       std::uint32_t nanoseconds) {
    auto& self = from(data);
    const auto seconds = (std::uint64_t{seconds_high} << 32U) | seconds_low;
    self.ready_ns = static_cast<std::int64_t>(seconds) * 1'000'000'000 + nanoseconds;
    self.done = true;
    wl_proxy_marshal_flags(frame, kDestroyFrame, nullptr, 1, WL_MARSHAL_FLAG_DESTROY);
  }

  static void on_failed(void* data, wl_proxy* frame) {
    auto& self = from(data);
    self.done = self.failed = true;
    wl_proxy_marshal_flags(frame, kDestroyFrame, nullptr, 1, WL_MARSHAL_FLAG_DESTROY);
  }

  void make_buffer(std::uint32_t format,
                   std::uint32_t wide,
                   std::uint32_t high,
                   std::uint32_t bytes_per_line) {
    width = wide;
    height = high;
    stride = bytes_per_line;
    mapped = std::size_t{stride} * height;
    const int memory = memfd_create("observed", MFD_CLOEXEC);
    if (memory < 0 || ftruncate(memory, static_cast<off_t>(mapped)) != 0) {
      throw std::runtime_error{"cannot share memory with the compositor"};
    }
    void* const where = mmap(nullptr, mapped, PROT_READ | PROT_WRITE, MAP_SHARED, memory, 0);
    if (where == MAP_FAILED) throw std::runtime_error{"cannot map shared memory"};
    pixels = static_cast<const std::uint8_t*>(where);
    auto* const pool = wl_shm_create_pool(shm, memory, static_cast<int>(mapped));
    buffer = wl_shm_pool_create_buffer(pool,
                                       0,
                                       static_cast<int>(width),
                                       static_cast<int>(height),
                                       static_cast<int>(stride),
                                       format);
    wl_shm_pool_destroy(pool);
    close(memory);
  }

  void request() {
    static const FrameListener listener{on_buffer, on_flags, on_ready, on_failed};
    done = failed = false;
    auto* const frame = wl_proxy_marshal_flags(manager,
                                               kCaptureRegion,
                                               &screencopy().frame,
                                               1,
                                               0,
                                               nullptr,
                                               0,
                                               output,
                                               region.x,
                                               region.y,
                                               region.width,
                                               region.height);
    auto* const functions = const_cast<FrameListener*>(&listener);
    wl_proxy_add_listener(frame, reinterpret_cast<void (**)()>(functions), this);
  }

  /// Mean of the green channel (second byte in every 32-bit format that compositors offer).
  [[nodiscard]] std::uint32_t levels() const {
    std::uint32_t packed = 0;
    const auto wide = width / static_cast<std::uint32_t>(columns);
    for (std::uint32_t column = 0; column < static_cast<std::uint32_t>(columns); ++column) {
      std::uint64_t sum = 0;
      for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < wide; ++x) {
          sum += pixels[std::size_t{stride} * y + 4 * (column * wide + x) + 1];
        }
      }
      packed |= static_cast<std::uint32_t>(sum / (std::uint64_t{wide} * height)) << (8 * column);
    }
    return packed;
  }
};

ScreenWatch::ScreenWatch(const Region& region, int columns)
    : connection_{std::make_unique<Connection>()} {
  auto& self = *connection_;
  self.region = region;
  self.columns = columns;
  self.display = wl_display_connect(nullptr);
  if (self.display == nullptr) throw std::runtime_error{"no compositor at WAYLAND_DISPLAY"};
  static constexpr wl_registry_listener kListener{Connection::on_global, Connection::on_removed};
  wl_registry_add_listener(wl_display_get_registry(self.display), &kListener, &self);
  wl_display_roundtrip(self.display);
  if (self.manager == nullptr || self.shm == nullptr || self.output == nullptr) {
    throw std::runtime_error{"the compositor cannot be watched: it has no wlr-screencopy"};
  }
}

ScreenWatch::~ScreenWatch() {
  if (connection_->display != nullptr) wl_display_disconnect(connection_->display);
  if (connection_->pixels != nullptr) {
    munmap(const_cast<std::uint8_t*>(connection_->pixels), connection_->mapped);
  }
}

void ScreenWatch::run(const std::function<bool()>& stopped,
                      const std::function<void(const SeenRefresh&)>& tell) {
  auto& self = *connection_;
  constexpr int kPatienceMs = 100;
  self.request();
  while (!stopped()) {
    while (wl_display_prepare_read(self.display) != 0) wl_display_dispatch_pending(self.display);
    wl_display_flush(self.display);
    pollfd readable{wl_display_get_fd(self.display), POLLIN, 0};
    if (poll(&readable, 1, kPatienceMs) > 0) {
      wl_display_read_events(self.display);
    } else {
      wl_display_cancel_read(self.display);
    }
    if (wl_display_dispatch_pending(self.display) < 0) {
      throw std::runtime_error{"the compositor has gone"};
    }
    if (!self.done) continue;
    if (!self.failed) tell({self.ready_ns, self.levels()});
    self.request();
  }
}

}  // namespace lab
