#include "protocols/reading/read_sound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace bimodal::protocols {

namespace {

using namespace std::chrono_literals;

constexpr NumberRule kSeconds{0, 60, "a time in seconds, e.g. 0.5"};
constexpr std::array<std::string_view, 1> kNoiseKinds{"white"};

/// Replaces a default by what was read, if anything was.
template <typename T>
void take(T& target, std::optional<T> read) {
  if (read) target = std::move(*read);
}

void read_band(ObjectReader& reader, Noise& noise, Findings& findings) {
  constexpr NumberRule kEdge{1, 96'000, "a frequency in Hz, e.g. 8000"};
  const auto edges = reader.items("band_hz", 2, 2);
  if (edges.empty()) return;
  const auto low = reader.number_of(*edges[0].first, edges[0].second, kEdge);
  const auto high = reader.number_of(*edges[1].first, edges[1].second, kEdge);
  if (!low || !high) return;
  if (*low >= *high) {
    findings.error(reader.pointer_to("band_hz"),
                   fmt::format("the lower edge, {} Hz, is not below the upper, {} Hz", *low, *high),
                   "write the lower edge first, e.g. [80, 8000]");
    return;
  }
  noise.band_low = Hertz{*low};
  noise.band_high = Hertz{*high};
}

void read_noise(ObjectReader& parent, Noise& noise, Findings& findings) {
  auto reader = parent.object("noise");
  if (!reader) return;
  static_cast<void>(reader->choice("kind", kNoiseKinds));
  read_band(*reader, noise, findings);
  take(noise.lead, reader->time("lead_s", 1s, kSeconds));
  take(noise.trail, reader->time("trail_s", 1s, kSeconds));
  take(noise.ramp, reader->time("ramp_ms", 1ms, {0, 1'000, "a time in milliseconds, e.g. 50"}));
  reader->refuse_unknown_keys();
}

void read_spl(ObjectReader& reader, Sound& sound, Findings& findings) {
  const auto level = reader.number(
      "speech_level_dbspl", {0, 110, "the RMS level of the speech at the ear in dB SPL, e.g. 65"});
  if (level) sound.speech_spl = DecibelsSpl{*level};
  if (!reader.has("speech_level_dbfs")) return;
  findings.error(reader.pointer_to("speech_level_dbspl"),
                 "the level of the speech cannot be given in two ways",
                 "write \"speech_level_dbfs\" or \"speech_level_dbspl\"");
}

void read_channels(ObjectReader& reader, Sound& sound, Findings& findings) {
  constexpr NumberRule kChannel{1, kMostChannels, "a channel of the output, from 1"};
  for (const auto& [value, pointer] : reader.items("channels", 1, kMostChannels)) {
    const auto channel = reader.number_of(*value, pointer, kChannel);
    if (!channel) continue;
    if (std::floor(*channel) != *channel) {
      findings.error(pointer,
                     fmt::format("{} is not a whole number", *channel),
                     fmt::format("give {}", kChannel.meaning));
      continue;
    }
    const auto number = static_cast<int>(*channel);
    if (std::ranges::find(sound.channels, number) != sound.channels.end()) {
      findings.error(
          pointer, fmt::format("channel {} is there already", number), "write each channel once");
    }
    sound.channels.push_back(number);
  }
}

}  // namespace

void read_sound(ObjectReader& parent, Sound& sound, Findings& findings) {
  auto reader = parent.object("sound");
  if (!reader) return;
  const auto rate = reader->whole("rate_hz", {8'000, 192'000, "samples per second, e.g. 48000"});
  if (rate) sound.rate = Hertz{static_cast<double>(*rate)};
  const auto level = reader->number(
      "speech_level_dbfs", {-80, 0, "the RMS level of the speech in dB re full scale, e.g. -30"});
  if (level) sound.speech_level = Decibels{*level};
  if (reader->has("speech_level_dbspl")) read_spl(*reader, sound, findings);
  read_channels(*reader, sound, findings);
  read_noise(*reader, sound.noise, findings);
  reader->refuse_unknown_keys();
}

}  // namespace bimodal::protocols
