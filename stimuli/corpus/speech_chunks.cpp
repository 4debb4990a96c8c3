#include "stimuli/corpus/speech_chunks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "stimuli/audio/biquad.hpp"

namespace bimodal {

namespace {

constexpr double kLowest = -120.0;
constexpr double kFloorPart = 0.1;
constexpr Duration kFloorReach = std::chrono::seconds{5};

/// For each frame, the quiet tenth of its surroundings. Taken once in half a second: the room does
/// not change faster.
std::vector<double> floors(const std::vector<double>& levels, Duration frame) {
  const auto reach = static_cast<std::size_t>(kFloorReach / frame);
  const std::size_t step = std::max<std::size_t>(1, reach / 10);
  std::vector<double> made(levels.size());
  std::vector<double> around;
  for (std::size_t from = 0; from < levels.size(); from += step) {
    const auto to = std::min(from + step, levels.size());
    const auto first = from > reach ? from - reach : 0;
    const auto last = std::min(to + reach, levels.size());
    around.assign(levels.begin() + static_cast<std::ptrdiff_t>(first),
                  levels.begin() + static_cast<std::ptrdiff_t>(last));
    const auto quiet = around.begin() + static_cast<std::ptrdiff_t>(
                                            kFloorPart * static_cast<double>(around.size() - 1));
    std::ranges::nth_element(around, quiet);
    std::fill(made.begin() + static_cast<std::ptrdiff_t>(from),
              made.begin() + static_cast<std::ptrdiff_t>(to),
              *quiet);
  }
  return made;
}

/// Frames from first up to, not including, end.
struct Run {
  std::size_t first = 0;
  std::size_t end = 0;
};

/// Where the level stays above the lower threshold, if it rises above the upper one within.
std::vector<Run> runs_of_speech(const std::vector<double>& levels, const ChunkOptions& options) {
  const auto floor = floors(levels, options.frame);
  const double least = levels.empty() ? 0.0 : std::ranges::max(levels) - options.range.count();
  std::vector<Run> runs;
  std::size_t i = 0;
  while (i < levels.size()) {
    const auto stays = [&](std::size_t at) {
      return levels[at] > kLowest &&
             levels[at] >= std::max(least, floor[at] + options.stays.count());
    };
    if (!stays(i)) {
      ++i;
      continue;
    }
    Run run{i, i};
    bool opened = false;
    for (; run.end < levels.size() && stays(run.end); ++run.end) {
      opened = opened || levels[run.end] >= floor[run.end] + options.opens.count();
    }
    i = run.end;
    if (opened) runs.push_back(run);
  }
  return runs;
}

}  // namespace

std::vector<double> frame_levels(const Clip& sound, const Band& band, Duration frame) {
  const double rate = sound.rate.count();
  auto high_pass = Biquad::high_pass(Hertz{std::min(band.low.count(), 0.2 * rate)}, sound.rate);
  // Close to half the rate there is nothing left to keep out.
  const bool is_limited = band.high.count() < 0.45 * rate;
  auto low_pass = Biquad::low_pass(Hertz{is_limited ? band.high.count() : 0.4 * rate}, sound.rate);
  const double length = rate * std::chrono::duration<double>{frame}.count();
  std::vector<double> levels;
  levels.reserve(static_cast<std::size_t>(static_cast<double>(sound.samples.size()) / length) + 1);
  std::size_t at = 0;
  for (std::size_t index = 1;; ++index) {
    const auto end = static_cast<std::size_t>(std::llround(length * static_cast<double>(index)));
    if (end > sound.samples.size()) return levels;
    double sum = 0.0;
    const auto count = static_cast<double>(end - at);
    for (; at < end; ++at) {
      const double heard = high_pass(static_cast<double>(sound.samples[at]));
      const double kept = is_limited ? low_pass(heard) : heard;
      sum += kept * kept;
    }
    levels.push_back(std::max(kLowest, 10.0 * std::log10(sum / count + 1e-30)));
  }
}

std::vector<SpeechInterval> find_speech(const Clip& sound, const ChunkOptions& options) {
  const auto runs = runs_of_speech(frame_levels(sound, options.band, options.frame), options);
  std::vector<SpeechInterval> chunks;
  for (const auto& run : runs) {
    const SpeechInterval chunk{options.frame * static_cast<std::int64_t>(run.first),
                               options.frame * static_cast<std::int64_t>(run.end)};
    if (!chunks.empty() && chunk.start - chunks.back().end <= options.longest_pause) {
      chunks.back().end = chunk.end;
    } else {
      chunks.push_back(chunk);
    }
  }
  std::erase_if(chunks, [&](const SpeechInterval& chunk) {
    return chunk.end - chunk.start < options.shortest;
  });
  return chunks;
}

}  // namespace bimodal
