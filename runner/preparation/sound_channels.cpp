#include "runner/preparation/sound_channels.hpp"

#include <algorithm>

namespace bimodal::runner {

namespace {

ChannelSet click_channels(const protocols::Click& click) {
  ChannelSet channels;
  channels.add(static_cast<std::size_t>(click.channel - 1));
  return channels;
}

}  // namespace

ChannelSet stimulus_channels(const protocols::Sound& sound) {
  if (sound.channels.empty()) return kBothEars;
  ChannelSet channels;
  for (const int channel : sound.channels) channels.add(static_cast<std::size_t>(channel - 1));
  return channels;
}

int channels_needed(const protocols::Protocol& protocol) {
  const auto& click = protocol.triggers.click;
  if (protocol.sound.channels.empty() && !click) return 0;
  const int heard = stimulus_channels(protocol.sound).channels_needed();
  return click ? std::max(heard, click_channels(*click).channels_needed()) : heard;
}

std::optional<Marker> click_marker(const protocols::Protocol& protocol, Duration sound_lead) {
  const auto& click = protocol.triggers.click;
  if (!click) return std::nullopt;
  const auto rate = protocol.sound.rate;
  const auto length = std::max<std::int64_t>(nearest_sample(click->length, rate).count(), 1);
  return Marker{.samples = std::make_shared<const std::vector<float>>(
                    static_cast<std::size_t>(length), static_cast<float>(click->amplitude)),
                .start = nearest_sample(sound_lead, rate).count(),
                .channels = click_channels(*click)};
}

}  // namespace bimodal::runner
