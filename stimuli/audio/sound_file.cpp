#include "stimuli/audio/sound_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <sndfile.h>

#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

using SoundFile = std::unique_ptr<SNDFILE, decltype([](SNDFILE* file) { sf_close(file); })>;

constexpr int kLowestRate = 4'000;
constexpr int kHighestRate = 384'000;
constexpr int kMostChannels = 64;
constexpr sf_count_t kLongestSeconds = 3600;

[[noreturn]] void refuse(std::string_view deed,
                         const std::filesystem::path& file,
                         std::string_view finding,
                         std::string_view remedy) {
  throw Error{fmt::format("cannot {} '{}': {}; {}", deed, file.string(), finding, remedy)};
}

void require_supported(const SF_INFO& header,
                       Channels channels,
                       const std::filesystem::path& file) {
  const int container = header.format & SF_FORMAT_TYPEMASK;
  const bool known = container == SF_FORMAT_WAV || container == SF_FORMAT_WAVEX ||
                     container == SF_FORMAT_RF64 || container == SF_FORMAT_FLAC;
  if (!known) refuse("read", file, "it is neither WAV nor FLAC", "convert it, e.g. with sox");
  if (header.samplerate < kLowestRate || header.samplerate > kHighestRate) {
    refuse("read",
           file,
           fmt::format("it has {} samples per second", header.samplerate),
           fmt::format("resample it to between {} and {}", kLowestRate, kHighestRate));
  }
  if (header.channels < 1 || header.channels > kMostChannels) {
    refuse("read", file, fmt::format("it has {} channels", header.channels), "give one of 1");
  }
  if (header.channels > 1 && channels == Channels::One) {
    refuse("read",
           file,
           fmt::format("it has {} channels", header.channels),
           "give a recording of one, e.g. by 'sox IN OUT remix 1'");
  }
  if (header.frames < 1) refuse("read", file, "it holds no samples", "record it again");
  if (header.frames > kLongestSeconds * header.samplerate) {
    refuse("read", file, "it is longer than an hour", "cut it into single stimuli");
  }
}

void require_finite(const Clip& sound, std::string_view deed, const std::filesystem::path& file) {
  const auto& samples = sound.samples;
  const auto bad =
      std::ranges::find_if_not(samples, [](float sample) { return std::isfinite(sample); });
  if (bad == samples.end()) return;
  refuse(deed,
         file,
         fmt::format("sample {} is not a finite number", bad - samples.begin()),
         "make the sound again");
}

void require_within_full_scale(const Clip& sound, const std::filesystem::path& file) {
  float largest = 0.0F;
  for (const float sample : sound.samples) largest = std::max(largest, std::abs(sample));
  if (largest <= 1.0F) return;
  refuse(
      "write",
      file,
      fmt::format("24-bit samples would clip, it is {:.1f} dB too loud", 20 * std::log10(largest)),
      "lower its level by that much or write floats");
}

}  // namespace

Clip read_sound(const std::filesystem::path& file, Channels channels) {
  if (std::filesystem::is_directory(file)) refuse("read", file, "it is a folder", "name a file");
  SF_INFO header{};
  const SoundFile opened{sf_open(file.c_str(), SFM_READ, &header)};
  if (!opened) {
    refuse("read", file, sf_strerror(nullptr), "check the path and that it is a WAV or FLAC file");
  }
  require_supported(header, channels, file);

  const auto channel_count = static_cast<std::size_t>(header.channels);
  Clip sound{Hertz{static_cast<double>(header.samplerate)}, {}};
  constexpr sf_count_t kBlock = 8192;
  std::vector<float> block(static_cast<std::size_t>(kBlock) * channel_count);
  while (true) {
    const auto count = sf_readf_float(opened.get(), block.data(), kBlock);
    if (count <= 0) break;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const auto frame = std::span{block}.subspan(i * channel_count, channel_count);
      const double sum = std::accumulate(frame.begin(), frame.end(), 0.0);
      sound.samples.push_back(static_cast<float>(sum / static_cast<double>(channel_count)));
    }
  }
  if (sound.samples.size() != static_cast<std::size_t>(header.frames)) {
    refuse("read",
           file,
           fmt::format("it ends after {} of {} samples", sound.samples.size(), header.frames),
           "copy or record it again");
  }
  require_finite(sound, "read", file);
  return sound;
}

void write_wav(const std::filesystem::path& file, const Clip& sound, SampleFormat format) {
  require_finite(sound, "write", file);
  const bool floats = format == SampleFormat::Float32;
  if (!floats) require_within_full_scale(sound, file);
  SF_INFO header{};
  header.samplerate = static_cast<int>(sound.rate.count());
  header.channels = 1;
  header.format = SF_FORMAT_WAV | (floats ? SF_FORMAT_FLOAT : SF_FORMAT_PCM_24);
  if (static_cast<double>(header.samplerate) != sound.rate.count() || header.samplerate < 1) {
    refuse("write",
           file,
           fmt::format("a WAV file cannot say {} samples per second", sound.rate.count()),
           "resample to a whole number");
  }
  Draft draft{file};
  SoundFile opened{sf_open(draft.path().c_str(), SFM_WRITE, &header)};
  if (!opened) {
    refuse("write", file, sf_strerror(nullptr), "check that its folder exists and can be written");
  }
  // The PEAK chunk holds the time of writing: equal sounds would make unequal files.
  sf_command(opened.get(), SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);
  const auto size = static_cast<sf_count_t>(sound.samples.size());
  const auto written = sf_writef_float(opened.get(), sound.samples.data(), size);
  const int closed = sf_close(opened.release());
  if (written != size || closed != 0) {
    refuse("write", file, "not all samples could be written", "check the free space of the disk");
  }
  draft.keep();
}

}  // namespace bimodal
