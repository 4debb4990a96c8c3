#include "synth/render/edge_smoothing.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace bimodal::synth {

namespace {

constexpr std::uint8_t kLeastContrast = 10;  // of 255; less is not seen as a staircase
constexpr std::uint8_t kLeastPartOfBrightest =
    8;                                // contrast below an eighth of the brightest is texture
constexpr int kLongestSearch = 12;    // pixels along an edge, each way
constexpr float kSpeckWeight = 0.6F;  // how much a single odd pixel is mixed with its surround
constexpr std::size_t kBytesPerPixel = 4;

void fill_luma(const Image& picture, std::vector<std::uint8_t>& luma) {
  luma.resize(picture.width * picture.height);
  const std::uint8_t* pixel = picture.pixels.data();
  for (std::uint8_t& value : luma) {
    value = static_cast<std::uint8_t>((77 * pixel[0] + 151 * pixel[1] + 28 * pixel[2]) >> 8);
    pixel += kBytesPerPixel;
  }
}

/// Flags with 1 where brightness jumps in one row, not at its ends. Written so that the compiler
/// handles 16 or 32 pixels at a time: nearly all pixels have no edge.
void flag_edges(const std::uint8_t* luma, std::size_t width, std::uint8_t* flags) {
  const std::uint8_t* above = luma - width;
  const std::uint8_t* below = luma + width;
  for (std::size_t x = 1; x + 1 < width; ++x) {
    const std::uint8_t across_most = std::max(luma[x - 1], luma[x + 1]);
    const std::uint8_t across_least = std::min(luma[x - 1], luma[x + 1]);
    const std::uint8_t most = std::max({across_most, luma[x], above[x], below[x]});
    const std::uint8_t least = std::min({across_least, luma[x], above[x], below[x]});
    const auto contrast = static_cast<std::uint8_t>(most - least);
    const auto texture = static_cast<std::uint8_t>(most / kLeastPartOfBrightest);
    flags[x] = contrast >= std::max(kLeastContrast, texture) ? 1 : 0;
  }
}

/// The brightness of a pixel and its neighbours, and what FXAA concludes from them.
class EdgePixel {
 public:
  EdgePixel(const std::uint8_t* luma, std::ptrdiff_t stride) : at_{luma}, stride_{stride} {}

  struct Mix {
    std::ptrdiff_t neighbour;  // in pixels from here
    float weight;              // 0..0.5 or so
  };

  /// `room`: how many pixels there are to the left, right, above and below, at least.
  [[nodiscard]] Mix mix(int room) const {
    const bool horizontal = bends(true) >= bends(false);
    const std::ptrdiff_t across = horizontal ? stride_ : 1;
    const std::ptrdiff_t along = horizontal ? 1 : stride_;
    const int before = std::abs(at_[-across] - *at_);
    const int after = std::abs(at_[across] - *at_);
    const std::ptrdiff_t neighbour = after >= before ? across : -across;
    const float by_edge = edge_coverage(neighbour, along, std::max(before, after), room);
    return {neighbour, std::max(by_edge, speck())};
  }

 private:
  [[nodiscard]] int luma(int x, int y) const { return at_[x + y * stride_]; }

  /// How strongly brightness bends across horizontal (or vertical) lines.
  [[nodiscard]] int bends(bool horizontal) const {
    const auto second = [this](int x, int y, int dx, int dy) {
      return std::abs(luma(x + dx, y + dy) + luma(x - dx, y - dy) - 2 * luma(x, y));
    };
    return horizontal ? second(-1, 0, 0, 1) + 2 * second(0, 0, 0, 1) + second(1, 0, 0, 1)
                      : second(0, -1, 1, 0) + 2 * second(0, 0, 1, 0) + second(0, 1, 1, 0);
  }

  /// Follows the edge between this pixel and `neighbour`; the nearer end tells how much of this
  /// pixel lies beyond the true line.
  [[nodiscard]] float edge_coverage(std::ptrdiff_t neighbour,
                                    std::ptrdiff_t along,
                                    int contrast,
                                    int room) const {
    const int here = *at_ + at_[neighbour];  // twice the brightness on the edge
    const int end_step = std::max(1, contrast / 2);
    const auto follow = [&](std::ptrdiff_t step) {
      int difference = 0;
      int steps = 0;
      const int longest = std::min(kLongestSearch, room);
      while (steps < longest) {
        ++steps;
        const std::uint8_t* probe = at_ + steps * step;
        difference = *probe + probe[neighbour] - here;
        if (std::abs(difference) >= end_step) break;
      }
      return std::pair{steps, difference};
    };
    const auto [back, end_back] = follow(-along);
    const auto [forth, end_forth] = follow(along);
    const int nearer = std::min(back, forth);
    const int end = back < forth ? end_back : end_forth;
    const bool darker_than_edge = 2 * *at_ < here;
    const bool crosses = (end < 0) != darker_than_edge && end != 0;
    if (!crosses) return 0.0F;
    return 0.5F - static_cast<float>(nearer) / static_cast<float>(back + forth);
  }

  /// A pixel unlike all its surround, such as a thin hair's.
  [[nodiscard]] float speck() const {
    const int sides = luma(1, 0) + luma(-1, 0) + luma(0, 1) + luma(0, -1);
    const int diagonals = luma(1, 1) + luma(-1, 1) + luma(1, -1) + luma(-1, -1);
    const auto [least, most] =
        std::minmax({luma(0, 0), luma(1, 0), luma(-1, 0), luma(0, 1), luma(0, -1)});
    const float surround = static_cast<float>(2 * sides + diagonals) / 12.0F;
    const float part = std::min(1.0F,
                                std::abs(surround - static_cast<float>(*at_)) /
                                    static_cast<float>(std::max(1, most - least)));
    const float smooth = part * part * (3.0F - 2.0F * part);
    return smooth * smooth * kSpeckWeight;
  }

  const std::uint8_t* at_;
  std::ptrdiff_t stride_;
};

}  // namespace

void EdgeSmoothing::apply(const Image& raw, Image& smooth) {
  assert(&raw != &smooth);
  fill_luma(raw, luma_);
  smooth = raw;
  const auto width = static_cast<std::ptrdiff_t>(raw.width);
  const auto height = static_cast<std::ptrdiff_t>(raw.height);
  flags_.assign(raw.width, 0);
  for (std::ptrdiff_t y = 1; y + 1 < height; ++y) {
    flag_edges(luma_.data() + y * width, raw.width, flags_.data());
    for (std::ptrdiff_t x = next_flag(0); x < width; x = next_flag(x + 1)) {
      const std::ptrdiff_t room = std::min({x, width - 1 - x, y, height - 1 - y});
      smooth_pixel(raw, y * width + x, static_cast<int>(room), smooth);
    }
  }
}

std::ptrdiff_t EdgeSmoothing::next_flag(std::ptrdiff_t from) const {
  const auto width = static_cast<std::ptrdiff_t>(flags_.size());
  const void* found = std::memchr(flags_.data() + from, 1, static_cast<std::size_t>(width - from));
  return found == nullptr ? width : static_cast<const std::uint8_t*>(found) - flags_.data();
}

void EdgeSmoothing::smooth_pixel(const Image& raw,
                                 std::ptrdiff_t here,
                                 int room,
                                 Image& smooth) const {
  const EdgePixel pixel{luma_.data() + here, static_cast<std::ptrdiff_t>(raw.width)};
  const auto [neighbour, weight] = pixel.mix(room);
  const std::size_t own = static_cast<std::size_t>(here) * kBytesPerPixel;
  const std::size_t other = static_cast<std::size_t>(here + neighbour) * kBytesPerPixel;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto value = static_cast<float>(raw.pixels[own + channel]);
    const float difference = static_cast<float>(raw.pixels[other + channel]) - value;
    smooth.pixels[own + channel] = static_cast<std::uint8_t>(value + weight * difference + 0.5F);
  }
}

}  // namespace bimodal::synth
