#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include <portaudio.h>

#include "runner/devices/portaudio/portaudio_output.hpp"
#include "runner/devices/portaudio/portaudio_session.hpp"
#include "runner/devices/sound_follower.hpp"
#include "runner/realtime/latest_ring.hpp"
#include "runner/realtime/mixer.hpp"
#include "runner/timing/stream_times.hpp"

namespace bimodal::runner {

/// The stream behind a PortaudioOutput: what its callback and the control side share (mixer,
/// times), and what only the control side touches (the rest).
struct OutputStream {
  explicit OutputStream(const PortaudioOptions& options);
  OutputStream(const OutputStream&) = delete;
  OutputStream& operator=(const OutputStream&) = delete;
  OutputStream(OutputStream&&) = delete;
  OutputStream& operator=(OutputStream&&) = delete;
  ~OutputStream();

  static constexpr std::size_t kReadings = 1UL << 14U;  ///< 22 s, at 64 frames a buffer

  /// What the callback was told, in words of 64 bits.
  struct Reading {
    std::int64_t sample;
    std::int64_t entry_ns;
    double current;
    double output;
    std::int64_t frames;
  };

  static int callback(const void* input,
                      void* output,
                      unsigned long frames,
                      const PaStreamCallbackTimeInfo* times,
                      PaStreamCallbackFlags flags,
                      void* stream) noexcept;

  void open(const PortaudioOptions& options);
  void await_clock();
  void collect();
  void note(const CallbackTimes& buffer, std::int64_t frames);
  void take_reports();
  void post(const MixerCommand& command);

  PortaudioSession session;
  AudioDevice device;
  Hertz rate;
  std::size_t channels;
  Mixer mixer;
  LatestRing<Reading, kReadings> times;

  PaStream* stream = nullptr;
  Duration latency{};  ///< as the host states it
  bool stream_times_plausible = false;
  std::string_view implausible_because;
  SoundFollower follower;
  Instant last_reading;

  std::map<std::uint64_t, Sound> borrowed;
  std::uint64_t present = 0;  ///< number of the last scheduled sound; 0: none
  std::int64_t start = 0;     ///< stream sample for which it is scheduled, without its silent head
};

}  // namespace bimodal::runner
