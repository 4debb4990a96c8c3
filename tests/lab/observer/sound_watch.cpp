#include "sound_watch.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <string>

#include <jack/jack.h>

#include "cycle_clock.hpp"

namespace lab {

namespace {

constexpr std::size_t kMostRefreshes = 1U << 20U;
constexpr std::size_t kMostTroubles = 1U << 12U;

std::int64_t monotonic_ns() noexcept {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

jack_client_t* open_client(const char* name) {
  auto* const client = jack_client_open(name, JackNoStartServer, nullptr);
  if (client == nullptr) throw std::runtime_error{"no JACK server"};
  return client;
}

std::int64_t playback_latency_frames(jack_client_t* client) {
  auto* const port = jack_port_by_name(client, "system:playback_1");
  if (port == nullptr) throw std::runtime_error{"the JACK server has no system:playback_1"};
  jack_latency_range_t range{};
  jack_port_get_latency_range(port, JackPlaybackLatency, &range);
  return range.max;
}

}  // namespace

struct SoundWatch::Client {
  struct Level {
    std::int64_t at_ns = 0;
    float brightness = 0.0F;
  };

  Options options;
  jack_client_t* listener = nullptr;  ///< two clients, or the graph would have a loop, in which
  jack_client_t* diode = nullptr;     ///< JACK delays one connection by a period
  std::vector<jack_port_t*> heard;
  std::array<jack_port_t*, 2> played{};
  std::int64_t playback_latency = 0;
  std::int64_t period = 0;
  double frames_per_second = 48000;

  std::vector<std::vector<float>> recorded;  ///< by channel
  std::unique_ptr<CycleClock> clock;         ///< of the frames that were listened to
  std::atomic<std::int64_t> listened{0};     ///< frames

  std::unique_ptr<CycleClock> diode_clock;  ///< of the frames that the diode played
  std::int64_t diode_frames = 0;            ///< for the diode's thread

  std::vector<Level> levels;
  std::atomic<std::size_t> level_count{0};
  std::size_t level_now = 0;  ///< for the diode's thread

  std::vector<SeenTrouble> troubles;
  std::atomic<std::size_t> trouble_count{0};

  static int listen(jack_nframes_t frames, void* data) {
    const auto now_ns = monotonic_ns();
    auto& self = *static_cast<Client*>(data);
    const auto at = self.listened.load(std::memory_order_relaxed);
    const auto room = static_cast<std::int64_t>(self.recorded.front().size());
    if (at + frames > room) return 0;
    for (std::size_t channel = 0; channel < self.heard.size(); ++channel) {
      const auto* const samples =
          static_cast<const float*>(jack_port_get_buffer(self.heard[channel], frames));
      std::copy(samples, samples + frames, self.recorded[channel].begin() + at);
    }
    self.clock->add(at, now_ns);
    self.listened.store(at + frames, std::memory_order_release);
    return 0;
  }

  /// A recorder at the far end of two long cables of equal delay: channel 0 is the photodiode,
  /// channel 1 what came out of the sound card.
  static int play(jack_nframes_t frames, void* data) {
    const auto now_ns = monotonic_ns();
    auto& self = *static_cast<Client*>(data);
    auto* const light = static_cast<float*>(jack_port_get_buffer(self.played[0], frames));
    auto* const sound = static_cast<float*>(jack_port_get_buffer(self.played[1], frames));
    const double frame_ns = 1e9 / self.frames_per_second;
    self.diode_clock->add(self.diode_frames, now_ns);
    // The samples of a cycle were captured in the period before it.
    const auto begin_ns = self.diode_clock->instant_of(self.diode_frames - self.period) -
                          std::llround(self.options.diode_delay_s * 1e9);
    self.diode_frames += frames;
    const auto known = self.level_count.load(std::memory_order_acquire);
    for (jack_nframes_t i = 0; i < frames; ++i) {
      const auto at = begin_ns + std::llround(frame_ns * i);
      while (self.level_now + 1 < known && self.levels[self.level_now + 1].at_ns <= at) {
        ++self.level_now;
      }
      light[i] = known == 0 ? 0.0F : 0.5F * self.levels[self.level_now].brightness;
    }
    const auto listened = self.listened.load(std::memory_order_acquire);
    const auto from = listened > 0 ? self.clock->frame_at(begin_ns) - self.playback_latency : -1;
    for (jack_nframes_t i = 0; i < frames; ++i) {
      const auto frame = from + static_cast<std::int64_t>(i);
      const bool is_known = from >= 0 && frame < listened;
      sound[i] = is_known ? self.recorded[0][static_cast<std::size_t>(frame)] : 0.0F;
    }
    return 0;
  }

  static int note_trouble(void* data) {
    auto& self = *static_cast<Client*>(data);
    const auto count = self.trouble_count.load();
    if (count == self.troubles.size()) return 0;
    self.troubles[count] = {monotonic_ns()};
    self.trouble_count.store(count + 1);
    return 0;
  }

  [[nodiscard]] std::int64_t output_ns(std::int64_t frame) const {
    const auto latency = static_cast<double>(playback_latency);
    return clock->instant_of(frame) + std::llround(latency * 1e9 / frames_per_second);
  }
};

SoundWatch::SoundWatch(const Options& options) : client_{std::make_unique<Client>()} {
  auto& self = *client_;
  self.options = options;
  self.listener = open_client("lab-listener");
  self.diode = open_client("lab-diode");
  self.frames_per_second = jack_get_sample_rate(self.listener);
  self.period = jack_get_buffer_size(self.listener);
  self.playback_latency = playback_latency_frames(self.listener);
  const auto frames = static_cast<std::size_t>(options.longest_s * self.frames_per_second);
  self.recorded.assign(static_cast<std::size_t>(options.channels), std::vector<float>(frames));
  const auto cycles = frames / static_cast<std::size_t>(self.period) + 1;
  self.clock = std::make_unique<CycleClock>(cycles, self.frames_per_second);
  self.diode_clock = std::make_unique<CycleClock>(cycles, self.frames_per_second);
  self.levels.resize(kMostRefreshes);
  self.troubles.resize(kMostTroubles);
  for (int channel = 0; channel < options.channels; ++channel) {
    const auto name = "heard_" + std::to_string(channel);
    self.heard.push_back(jack_port_register(
        self.listener, name.c_str(), JACK_DEFAULT_AUDIO_TYPE, JackPortIsInput, 0));
  }
  self.played[0] =
      jack_port_register(self.diode, "light", JACK_DEFAULT_AUDIO_TYPE, JackPortIsOutput, 0);
  self.played[1] =
      jack_port_register(self.diode, "sound", JACK_DEFAULT_AUDIO_TYPE, JackPortIsOutput, 0);
  jack_set_process_callback(self.listener, &Client::listen, &self);
  jack_set_process_callback(self.diode, &Client::play, &self);
  jack_set_xrun_callback(self.listener, &Client::note_trouble, &self);
  if (jack_activate(self.listener) != 0 || jack_activate(self.diode) != 0) {
    throw std::runtime_error{"the JACK server does not run its clients"};
  }
}

SoundWatch::~SoundWatch() {
  jack_client_close(client_->diode);
  jack_client_close(client_->listener);
}

bool SoundWatch::connect(const std::string& client_pattern) {
  auto& self = *client_;
  const auto port = [&](const std::string& name) {
    return jack_port_by_name(self.listener, (client_pattern + ":" + name).c_str());
  };
  bool connected = false;
  for (std::size_t channel = 0; channel < self.heard.size(); ++channel) {
    auto* const source = port("out_" + std::to_string(channel));
    if (source == nullptr) continue;
    if (jack_port_connected_to(self.heard[channel], jack_port_name(source)) == 0) {
      jack_connect(self.listener, jack_port_name(source), jack_port_name(self.heard[channel]));
    }
    connected = true;
  }
  for (std::size_t channel = 0; channel < self.played.size(); ++channel) {
    auto* const target = port("in_" + std::to_string(channel));
    if (target == nullptr) continue;
    if (jack_port_connected_to(self.played[channel], jack_port_name(target)) != 0) continue;
    const auto card = "system:capture_" + std::to_string(channel + 1);
    jack_disconnect(self.listener, card.c_str(), jack_port_name(target));
    jack_connect(self.listener, jack_port_name(self.played[channel]), jack_port_name(target));
  }
  return connected;
}

void SoundWatch::show(std::int64_t at_ns, float brightness) {
  auto& self = *client_;
  const auto count = self.level_count.load(std::memory_order_relaxed);
  if (count == self.levels.size()) return;
  self.levels[count] = {at_ns, brightness};
  self.level_count.store(count + 1, std::memory_order_release);
}

std::vector<SeenSound> SoundWatch::sounds() const {
  const auto& self = *client_;
  const auto frames = self.listened.load();
  const auto silence = std::llround(self.options.silence_s * self.frames_per_second);
  std::vector<SeenSound> found;
  for (std::size_t channel = 0; channel < self.recorded.size(); ++channel) {
    std::int64_t last_sound = -silence;
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      const float sample = self.recorded[channel][static_cast<std::size_t>(frame)];
      if (std::abs(sample) <= self.options.threshold) continue;
      if (frame - last_sound >= silence) {
        found.push_back({static_cast<int>(channel), self.output_ns(frame), sample});
      }
      last_sound = frame;
    }
  }
  return found;
}

std::vector<SeenTrouble> SoundWatch::troubles() const {
  return {client_->troubles.begin(),
          client_->troubles.begin() + static_cast<std::ptrdiff_t>(client_->trouble_count.load())};
}

}  // namespace lab
