#include "stimuli/picture/resize.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace bimodal {

namespace {

constexpr std::size_t kChannels = 4;

/// What one pixel of the result is made of: weights that add up to 1, from `first` on.
struct Tap {
  std::size_t first = 0;
  std::vector<float> weights;
};

double catmull_rom(double x) {
  x = std::abs(x);
  if (x < 1.0) return 1.5 * x * x * x - 2.5 * x * x + 1.0;
  if (x < 2.0) return -0.5 * x * x * x + 2.5 * x * x - 4.0 * x + 2.0;
  return 0.0;
}

/// The taps of every pixel of a row of `to` pixels made from `from` pixels; `kernel` is zero beyond
/// `radius`, in pixels of the source.
template <typename Kernel>
std::vector<Tap> make_taps(std::size_t from, std::size_t to, double radius, Kernel kernel) {
  std::vector<Tap> taps(to);
  const double scale = static_cast<double>(from) / static_cast<double>(to);
  const auto last = static_cast<std::int64_t>(from) - 1;
  for (std::size_t i = 0; i < to; ++i) {
    const double centre = (static_cast<double>(i) + 0.5) * scale - 0.5;
    const auto begin = static_cast<std::int64_t>(std::ceil(centre - radius));
    const auto end = static_cast<std::int64_t>(std::floor(centre + radius));
    auto& tap = taps[i];
    const auto first = std::clamp<std::int64_t>(begin, 0, last);
    tap.first = static_cast<std::size_t>(first);
    tap.weights.assign(static_cast<std::size_t>(std::clamp<std::int64_t>(end, 0, last) - first) + 1,
                       0.0F);
    double sum = 0.0;
    for (auto at = begin; at <= end; ++at) sum += kernel(static_cast<double>(at) - centre);
    for (auto at = begin; at <= end; ++at) {
      const auto place = static_cast<std::size_t>(std::clamp<std::int64_t>(at, 0, last) - first);
      tap.weights[place] += static_cast<float>(kernel(static_cast<double>(at) - centre) / sum);
    }
  }
  return taps;
}

std::uint8_t to_byte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
}

Image filtered(const Image& image, const std::vector<Tap>& across, const std::vector<Tap>& down) {
  const std::size_t width = across.size();
  std::vector<float> rows(width * image.height * kChannels);
  for (std::size_t y = 0; y < image.height; ++y) {
    const auto* const source = &image.pixels[y * image.width * kChannels];
    auto* target = &rows[y * width * kChannels];
    for (const auto& tap : across) {
      for (std::size_t channel = 0; channel < kChannels; ++channel) {
        float sum = 0.0F;
        for (std::size_t i = 0; i < tap.weights.size(); ++i) {
          sum += tap.weights[i] * static_cast<float>(source[(tap.first + i) * kChannels + channel]);
        }
        *target++ = sum;
      }
    }
  }
  Image made{.width = width, .height = down.size(), .pixels = {}};
  made.pixels.resize(width * down.size() * kChannels);
  std::vector<float> sums(width * kChannels);
  for (std::size_t y = 0; y < down.size(); ++y) {
    const auto& tap = down[y];
    std::ranges::fill(sums, 0.0F);
    for (std::size_t i = 0; i < tap.weights.size(); ++i) {
      const float weight = tap.weights[i];
      const auto* const row = &rows[(tap.first + i) * width * kChannels];
      for (std::size_t x = 0; x < sums.size(); ++x) sums[x] += weight * row[x];
    }
    std::ranges::transform(
        sums, made.pixels.begin() + static_cast<std::ptrdiff_t>(y * width * kChannels), to_byte);
  }
  return made;
}

}  // namespace

Image resized(const Image& image, std::size_t width, std::size_t height) {
  assert(width > 0 && height > 0 && !image.pixels.empty());
  if (width == image.width && height == image.height) return image;
  const auto taps = [](std::size_t from, std::size_t to) {
    const double widening = std::max(1.0, static_cast<double>(from) / static_cast<double>(to));
    return make_taps(
        from, to, 2.0 * widening, [widening](double x) { return catmull_rom(x / widening); });
  };
  return filtered(image, taps(image.width, width), taps(image.height, height));
}

Image blurred(const Image& image, double deviation_px) {
  assert(deviation_px >= 0.0);
  if (deviation_px == 0.0) return image;
  const auto gaussian = [deviation_px](double x) {
    return std::exp(-x * x / (2.0 * deviation_px * deviation_px));
  };
  const double radius = 3.0 * deviation_px;
  return filtered(image,
                  make_taps(image.width, image.width, radius, gaussian),
                  make_taps(image.height, image.height, radius, gaussian));
}

}  // namespace bimodal
