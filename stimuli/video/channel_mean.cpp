#include "stimuli/video/channel_mean.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace bimodal::libav {

namespace {

template <typename Sample>
double full_scale(Sample sample) {
  if constexpr (std::is_same_v<Sample, std::uint8_t>) {
    return (static_cast<double>(sample) - 128.0) / 128.0;
  } else if constexpr (std::is_integral_v<Sample>) {
    return static_cast<double>(sample) / -static_cast<double>(std::numeric_limits<Sample>::min());
  } else {
    return static_cast<double>(sample);
  }
}

template <typename Sample>
void append(const AVFrame& frame, bool planar, std::vector<float>& samples) {
  const auto channels = static_cast<std::size_t>(frame.ch_layout.nb_channels);
  const auto count = static_cast<std::size_t>(frame.nb_samples);
  const auto plane = [&](std::size_t channel) {
    return reinterpret_cast<const Sample*>(frame.extended_data[channel]);
  };
  samples.reserve(samples.size() + count);
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0.0;
    for (std::size_t channel = 0; channel < channels; ++channel) {
      sum += full_scale(planar ? plane(channel)[i] : plane(0)[i * channels + channel]);
    }
    samples.push_back(static_cast<float>(sum / static_cast<double>(channels)));
  }
}

}  // namespace

bool append_channel_mean(const AVFrame& frame, std::vector<float>& samples) {
  const auto format = static_cast<AVSampleFormat>(frame.format);
  const bool planar = av_sample_fmt_is_planar(format) != 0;
  switch (av_get_packed_sample_fmt(format)) {
    case AV_SAMPLE_FMT_U8:
      append<std::uint8_t>(frame, planar, samples);
      return true;
    case AV_SAMPLE_FMT_S16:
      append<std::int16_t>(frame, planar, samples);
      return true;
    case AV_SAMPLE_FMT_S32:
      append<std::int32_t>(frame, planar, samples);
      return true;
    case AV_SAMPLE_FMT_S64:
      append<std::int64_t>(frame, planar, samples);
      return true;
    case AV_SAMPLE_FMT_FLT:
      append<float>(frame, planar, samples);
      return true;
    case AV_SAMPLE_FMT_DBL:
      append<double>(frame, planar, samples);
      return true;
    default:
      return false;
  }
}

}  // namespace bimodal::libav
