#include "stimuli/video/sound_encoder.hpp"

#include <algorithm>
#include <utility>

#include "stimuli/audio/resample.hpp"

namespace bimodal::libav {

namespace {

constexpr int kRate = 48'000;

CodecContext opened(const ContainerWriter& container, const char* name, std::int64_t bits) {
  auto codec = container.encoder(name);
  codec->sample_rate = kRate;
  codec->time_base = {.num = 1, .den = kRate};
  codec->bit_rate = bits;
  codec->sample_fmt = codec->codec->sample_fmts[0];
  for (const auto* format = codec->codec->sample_fmts; *format != AV_SAMPLE_FMT_NONE; ++format) {
    if (*format == AV_SAMPLE_FMT_FLT) codec->sample_fmt = *format;
  }
  av_channel_layout_default(&codec->ch_layout, 1);
  return codec;
}

}  // namespace

SoundEncoder::SoundEncoder(ContainerWriter& container,
                           const char* encoder,
                           std::int64_t bits,
                           const Clip& sound)
    : container_{container},
      track_{container, opened(container, encoder, bits)},
      sound_{resample(sound, Hertz{kRate})} {}

void SoundEncoder::encode_block() {
  const auto& codec = track_.encoder();
  const auto count =
      std::min(static_cast<std::size_t>(codec.frame_size), sound_.samples.size() - done_);
  frame_->nb_samples = static_cast<int>(count);
  frame_->format = codec.sample_fmt;
  frame_->sample_rate = codec.sample_rate;
  container_.judge(av_channel_layout_copy(&frame_->ch_layout, &codec.ch_layout));
  container_.judge(av_frame_get_buffer(frame_.get(), 0));
  // In one channel, planes and interleaved samples are the same.
  std::copy_n(sound_.samples.begin() + static_cast<std::ptrdiff_t>(done_),
              count,
              reinterpret_cast<float*>(frame_->data[0]));
  frame_->pts = static_cast<std::int64_t>(done_);
  done_ += count;
  track_.encode(frame_.get());
  av_frame_unref(frame_.get());
}

void SoundEncoder::encode_until(Milliseconds time) {
  const auto end = time.count() / 1e3 * kRate;
  while (done_ < sound_.samples.size() && static_cast<double>(done_) < end) encode_block();
}

void SoundEncoder::finish() {
  while (done_ < sound_.samples.size()) encode_block();
  track_.encode(nullptr);
}

}  // namespace bimodal::libav
