#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "runner/realtime/channel_set.hpp"
#include "runner/realtime/spsc_queue.hpp"

namespace bimodal::runner {

/// Samples that are played with a sound, on channels of their own; borrowed as the sound's are.
struct MixerMarker {
  const float* samples = nullptr;
  std::int64_t length = 0;  ///< 0: none
  std::int64_t start = 0;   ///< the sound's sample that is played with its first one; >= 0
  ChannelSet channels;
};

/// What the control side asks of the mixer. Samples are borrowed: they must stay where they are
/// until the Finished report of their sound.
struct MixerCommand {
  enum class Kind : std::uint8_t {
    Start,  ///< play from stream sample `start`; fades out what plays and drops what waits
    Stop,   ///< fade out what plays and drop what waits
    Move,   ///< `sound`, if it has not begun: play from stream sample `start`
  };
  Kind kind = Kind::Stop;
  std::uint64_t sound = 0;  ///< the caller's number for it, returned in reports
  const float* samples = nullptr;
  std::int64_t length = 0;
  std::int64_t start = 0;  ///< stream sample; in the past: at once, and the report says where
  ChannelSet channels = kBothEars;
  MixerMarker marker{};  ///< goes where the sound goes: late by as much, faded with it
};

/// What the mixer tells the control side.
struct MixerReport {
  enum class Kind : std::uint8_t {
    Started,   ///< its first sample is stream sample `at`
    Finished,  ///< its last sample has been rendered before `at`; it is no longer borrowed
  };
  Kind kind = Kind::Finished;
  std::uint64_t sound = 0;
  std::int64_t at = 0;
  std::int64_t underflows = 0;  ///< buffers that came late while it played; in Finished
};

/// Places sounds of one channel into an endless stream at exact samples, each on its channels; the
/// others stay exactly silent. `render` belongs to the
/// audio callback: it never locks, allocates, throws or prints. `post` and `next_report` belong to
/// one other thread. The stream's samples are counted from 0 by what was rendered.
class Mixer {
 public:
  /// The fade of a sound that is stopped, in samples (raised cosine).
  explicit Mixer(std::int64_t fade_length) : fade_length_{fade_length} {}

  /// False if the mixer has not yet taken earlier commands: the stream does not run.
  [[nodiscard]] bool post(const MixerCommand& command) noexcept {
    return commands_.try_push(command);
  }

  [[nodiscard]] std::optional<MixerReport> next_report() noexcept { return reports_.try_pop(); }

  /// Fills `output` (frame after frame, `channels` samples each) with the next samples of the
  /// stream. `underflow`: the device ran dry before this buffer.
  void render(std::span<float> output, std::size_t channels, bool underflow) noexcept;

  /// The stream sample that the next render() begins with. For the rendering thread.
  [[nodiscard]] std::int64_t position() const noexcept { return position_; }

 private:
  struct Voice {
    bool used = false;
    bool started = false;           ///< its first sample has been rendered
    bool started_reported = false;  ///< a full queue may delay reports; they are never lost
    bool finished = false;
    MixerCommand command;
    std::int64_t started_at = 0;
    std::int64_t finished_at = 0;
    std::int64_t next = 0;        ///< index of the sample to come
    std::int64_t fade_left = -1;  ///< samples left of its fade; < 0: not fading
    std::int64_t underflows = 0;
  };

  static constexpr std::size_t kVoices = 8;  ///< one plays, the others fade or wait to be reported
  static constexpr std::size_t kQueue = 64;

  void take_commands() noexcept;
  void release_all() noexcept;
  void begin(const MixerCommand& command) noexcept;
  void move(const MixerCommand& command) noexcept;
  void add(Voice& voice, std::span<float> output, std::size_t channels) const noexcept;
  void report(Voice& voice) noexcept;

  SpscQueue<MixerCommand, kQueue> commands_;
  SpscQueue<MixerReport, kQueue> reports_;
  std::array<Voice, kVoices> voices_{};
  std::optional<MixerCommand> waiting_;  ///< a start for which no voice was free
  std::int64_t position_ = 0;
  std::int64_t fade_length_;
};

}  // namespace bimodal::runner
