#include "stimuli/alignment/edge_correction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "stimuli/alignment/cepstra.hpp"

namespace bimodal {

namespace {

using enum Phone;
using std::chrono::milliseconds;

constexpr Duration kShortestPhone = milliseconds{30};
constexpr Duration kLatestEnd = milliseconds{50};
constexpr Duration kVoicelessClosure = milliseconds{30};
constexpr Duration kVoicedClosure = milliseconds{10};
constexpr Duration kSonorantLag = milliseconds{12};
constexpr Duration kLiquidLag = milliseconds{20};
constexpr double kBelowPeak = 35.0;
constexpr double kWeakBelowPeak = 40.0;
constexpr double kAboveFloor = 8.0;

constexpr std::array kVoicelessClosed{P, T, K, CH};
constexpr std::array kVoicedClosed{B, D, G, JH};
constexpr std::array kWeakEnds{P, T, K, CH, F, V, TH, DH, S, SH, HH};
constexpr std::array kSonorants{M, N, NG, L, R, W, WH, Y};
constexpr std::array kLiquids{L, R};

bool is_one_of(std::span<const Phone> phones, Phone phone) {
  return std::ranges::find(phones, phone) != phones.end();
}

/// Levels of a recording in dB over windows of 10 ms, every 2.5 ms.
class Levels {
 public:
  explicit Levels(const SearchSound& sound) : padding_{sound.padding} {
    const auto samples = std::span{sound.samples};
    for (std::size_t first = 0; first + kWindow <= samples.size(); first += kHop) {
      double sum = 1.0;
      for (const double sample : samples.subspan(first, kWindow)) sum += sample * sample;
      levels_.push_back(10.0 * std::log10(sum / static_cast<double>(kWindow)));
    }
  }

  [[nodiscard]] double at(std::size_t window) const { return levels_[window]; }

  /// The window whose middle is nearest to an instant of the recording.
  [[nodiscard]] std::size_t window_at(Duration instant) const {
    const auto sample = nearest_sample(instant + padding_, CepstraMaker::kRate).count();
    const auto before = static_cast<std::size_t>(std::max<std::int64_t>(sample, 0)) + kHop / 2;
    const auto window = (std::max(before, kWindow / 2) - kWindow / 2) / kHop;
    return std::min(window, levels_.size() - 1);
  }

  [[nodiscard]] Duration middle(std::size_t window) const {
    return static_cast<std::int64_t>(window) * kHopTime + kWindowTime / 2 - padding_;
  }

  /// Of the windows around all instants from one to another, never none.
  [[nodiscard]] std::span<const double> between(Duration start, Duration end) const {
    const auto first = window_at(start);
    return std::span{levels_}.subspan(first, std::max(window_at(end), first) - first + 1);
  }

 private:
  static constexpr std::size_t kHop = 40;
  static constexpr std::size_t kWindow = 160;
  static constexpr Duration kHopTime = std::chrono::microseconds{2500};
  static constexpr Duration kWindowTime = milliseconds{10};

  Duration padding_;
  std::vector<double> levels_;
};

/// Where the sound of the phone before the rest phones[rest] dies away; the speech is
/// phones[first] to phones[rest - 1].
Duration end_of_sound(std::span<const TimedPhone> phones,
                      std::size_t first,
                      std::size_t rest,
                      const Levels& levels) {
  const auto& last = phones[rest - 1];
  const auto edge = phones[rest].start;
  const auto rest_end = rest + 1 < phones.size() ? phones[rest + 1].start : edge + kLatestEnd;
  const double peak = std::ranges::max(levels.between(phones[first].start, edge));
  const double floor = std::ranges::min(levels.between(edge, rest_end));
  const double below = is_one_of(kWeakEnds, last.phone) ? kWeakBelowPeak : kBelowPeak;
  const double threshold = std::max(peak - below, floor + kAboveFloor);
  const auto earliest = last.start + kShortestPhone;
  auto window = levels.window_at(std::min(edge + kLatestEnd, rest_end));
  while (levels.middle(window) > earliest && levels.at(window) < threshold) --window;
  return std::max(levels.middle(window), earliest);
}

Duration lead(Phone before, Phone phone) {
  if (before == Rest) {
    if (is_one_of(kVoicelessClosed, phone)) return kVoicelessClosure;
    if (is_one_of(kVoicedClosed, phone)) return kVoicedClosure;
    return {};
  }
  if (is_vowel(before) && is_one_of(kLiquids, phone)) return kLiquidLag;
  if (phone == Rest || !is_one_of(kSonorants, before) || is_one_of(kSonorants, phone)) return {};
  return is_one_of(kLiquids, before) ? kLiquidLag : kSonorantLag;
}

}  // namespace

void correct_edges(std::vector<TimedPhone>& phones, const SearchSound& sound) {
  const Levels levels{sound};
  std::size_t first = 0;
  for (std::size_t i = 1; i < phones.size(); ++i) {
    if (phones[i - 1].phone == Rest) first = i;
    if (phones[i].phone == Rest && i > first) {
      phones[i].start = end_of_sound(phones, first, i, levels);
    }
  }
  for (std::size_t i = 1; i < phones.size(); ++i) {
    const auto earliest = phones[i - 1].phone == Rest ? phones[i - 1].start : Duration::min();
    phones[i].start =
        std::max(phones[i].start - lead(phones[i - 1].phone, phones[i].phone), earliest);
  }
}

}  // namespace bimodal
