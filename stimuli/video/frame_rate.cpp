#include "stimuli/video/frame_rate.hpp"

#include <cassert>
#include <charconv>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace bimodal {

namespace {

constexpr std::int64_t kMillion = 1'000'000;

bool is_within_limits(double rate) {
  return rate >= kLowestFrameRate.count() && rate <= kHighestFrameRate.count();
}

template <typename Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const auto* const end = text.data() + text.size();
  const auto [stopped, fault] = std::from_chars(text.data(), end, value);
  if (fault != std::errc{} || stopped != end) return std::nullopt;
  return value;
}

}  // namespace

std::int64_t FrameRate::frames_before(Milliseconds end) const {
  auto count = static_cast<std::int64_t>(end.count() / 1e3 * hertz().count());
  while (count > 0 && time_of(count - 1) >= end) --count;
  while (time_of(count) < end) ++count;
  return count;
}

FrameRate frame_rate_of(std::int64_t pictures, std::int64_t seconds) {
  const auto common = std::gcd(pictures, seconds);
  return {.pictures = pictures / common, .seconds = seconds / common};
}

FrameRate frame_rate_near(Hertz rate) {
  const double exact = rate.count();
  assert(is_within_limits(exact));
  constexpr double kRounding = 0.005;  // 23.98 is meant to be 24000/1001
  const auto whole = static_cast<std::int64_t>(std::ceil(exact));
  const bool is_of_film = whole % 24 == 0 || whole % 30 == 0;
  const double slowed = static_cast<double>(whole) * 1000 / 1001;
  if (is_of_film && std::abs(exact - slowed) < kRounding) return frame_rate_of(whole * 1000, 1001);
  return frame_rate_of(std::llround(exact * static_cast<double>(kMillion)), kMillion);
}

std::optional<FrameRate> parse_frame_rate(std::string_view text) {
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) {
    const auto rate = number<double>(text);
    if (!rate || !is_within_limits(*rate)) return std::nullopt;
    return frame_rate_near(Hertz{*rate});
  }
  const auto pictures = number<std::int64_t>(text.substr(0, slash));
  const auto seconds = number<std::int64_t>(text.substr(slash + 1));
  const auto is_usable = [](const auto& part) { return part && *part > 0 && *part <= kMillion; };
  if (!is_usable(pictures) || !is_usable(seconds)) return std::nullopt;
  const auto rate = frame_rate_of(*pictures, *seconds);
  if (!is_within_limits(rate.hertz().count())) return std::nullopt;
  return rate;
}

std::string describe(const FrameRate& rate) {
  if (rate.seconds == 1) return fmt::to_string(rate.pictures);
  return fmt::format("{:.5g} ({}/{})", rate.hertz().count(), rate.pictures, rate.seconds);
}

}  // namespace bimodal
