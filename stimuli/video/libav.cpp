#include "stimuli/video/libav.hpp"

#include <array>
#include <cstdlib>
#include <new>

#include <fmt/format.h>

extern "C" {
#include <libavutil/error.h>
#include <libavutil/mathematics.h>
}

#include "stimuli/base/error.hpp"

namespace bimodal::libav {

void be_silent() {
  static const bool once = (av_log_set_level(AV_LOG_QUIET), true);
  static_cast<void>(once);
}

Frame new_frame() {
  Frame made{av_frame_alloc()};
  if (!made) throw std::bad_alloc{};
  return made;
}

Packet new_packet() {
  Packet made{av_packet_alloc()};
  if (!made) throw std::bad_alloc{};
  return made;
}

std::optional<Duration> duration_of(std::int64_t stamp, AVRational unit) {
  constexpr std::int64_t kFarthest = 1'000'000'000'000'000'000;
  constexpr AVRational kNanosecond{.num = 1, .den = 1'000'000'000};
  if (stamp == AV_NOPTS_VALUE || unit.num <= 0 || unit.den <= 0) return std::nullopt;
  const auto exact = static_cast<double>(stamp) * av_q2d(unit) * 1e9;
  if (std::abs(exact) > static_cast<double>(kFarthest)) return std::nullopt;
  return Duration{av_rescale_q(stamp, unit, kNanosecond)};
}

std::string words_of(int code) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(code, text.data(), text.size());
  return text.data();
}

std::string in_seconds(Duration time) {
  return fmt::format("{:.3f} s", std::chrono::duration<double>{time}.count());
}

void refuse(std::string_view deed,
            const std::filesystem::path& file,
            std::string_view finding,
            std::string_view remedy) {
  throw Error{fmt::format("cannot {} '{}': {}; {}", deed, file.string(), finding, remedy)};
}

}  // namespace bimodal::libav
