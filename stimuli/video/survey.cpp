#include "stimuli/video/survey.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

extern "C" {
#include <libavutil/display.h>
#include <libavutil/intreadwrite.h>
#include <libavutil/pixdesc.h>
}

#include "stimuli/video/container.hpp"
#include "stimuli/video/track_decoder.hpp"

namespace bimodal::libav {

namespace {

constexpr auto kDeed = "read";
constexpr Duration kLookThrough = std::chrono::minutes{1};
/// Frames are stored before those that they are predicted from are seen: so much later, at most.
constexpr Duration kReordering = std::chrono::seconds{2};
/// Packets without a first frame after which a track counts as damaged.
constexpr int kMostSilentPackets = 3000;

/// What is learnt of one track while packets pass by.
struct TrackView {
  AVStream* track = nullptr;
  std::optional<TrackDecoder> decoder;
  Frame first;                      ///< empty until it is decoded
  std::optional<Duration> start;    ///< of the first frame, once it is decoded
  std::optional<Duration> end;      ///< the latest end of a packet
  std::optional<Duration> reached;  ///< the latest time of decoding
  std::optional<Duration> stored;   ///< the first one
  int silent_packets = 0;
  bool complete = true;
  std::vector<Duration> starts;

  [[nodiscard]] bool waiting() const {
    return track != nullptr && !first && silent_packets < kMostSilentPackets;
  }
};

void keep_first(TrackView& view, const AVPacket* packet) {
  if (!view.waiting() || !view.decoder) return;
  ++view.silent_packets;
  if (view.decoder->push(packet) < 0 && packet != nullptr) return;
  auto frame = new_frame();
  if (view.decoder->pull(*frame) < 0) return;
  if (const auto start = duration_of(frame->best_effort_timestamp, view.track->time_base)) {
    view.start = start;
  }
  view.first = std::move(frame);
}

/// Samples at the packet's end that are to be thrown away although its duration counts them.
Duration padding_of(const AVPacket& packet, const AVStream& track, bool ogg) {
  if (ogg) return {};  // whose durations do not
  constexpr std::size_t kSize = 10;
  std::size_t size = 0;
  const auto* side = av_packet_get_side_data(&packet, AV_PKT_DATA_SKIP_SAMPLES, &size);
  if (side == nullptr || size < kSize || track.codecpar->sample_rate <= 0) return {};
  return duration_of(AV_RL32(side + 4), AVRational{1, track.codecpar->sample_rate})
      .value_or(Duration{});
}

void note(TrackView& view, const AVPacket& packet, bool ogg) {
  const auto unit = view.track->time_base;
  const auto start = duration_of(packet.pts, unit);
  const auto stored = duration_of(packet.dts, unit);
  if (const auto time = stored ? stored : start) {
    view.reached = std::max(view.reached.value_or(*time), *time);
    if (!view.stored) view.stored = time;
  }
  if ((packet.flags & AV_PKT_FLAG_DISCARD) != 0) return;
  if (!start) view.complete = false;
  const auto known = start ? start : stored;
  if (!known) return;
  auto end = *known + std::max(duration_of(packet.duration, unit).value_or(Duration{}), Duration{});
  end -= padding_of(packet, *view.track, ogg);
  view.end = std::max(view.end.value_or(end), end);
  if (start && view.track->codecpar->codec_type == AVMEDIA_TYPE_VIDEO) {
    view.starts.push_back(*start);
  }
}

FrameTimes times_of(const TrackView& view) {
  return frame_times(*view.track, view.starts, view.start.value_or(Duration::min()), view.complete);
}

/// Degrees clockwise by which the stored picture is turned to be upright.
int rotation_of(const AVStream& track, const std::filesystem::path& file) {
  constexpr std::size_t kMatrix = 9;
  std::size_t size = 0;
  const auto* side = av_stream_get_side_data(&track, AV_PKT_DATA_DISPLAYMATRIX, &size);
  std::array<std::int32_t, kMatrix> matrix{};
  if (side == nullptr || size < sizeof matrix) return 0;
  std::memcpy(matrix.data(), side, sizeof matrix);
  const double anticlockwise = av_display_rotation_get(matrix.data());
  const double determinant = static_cast<double>(matrix[0]) * static_cast<double>(matrix[4]) -
                             static_cast<double>(matrix[1]) * static_cast<double>(matrix[3]);
  const double quarters = std::isfinite(anticlockwise) ? -anticlockwise / 90.0 : 0.5;
  if (determinant <= 0.0 || std::abs(quarters - std::round(quarters)) > 0.01) {
    refuse(kDeed,
           file,
           "it is to be shown mirrored or at a slant",
           "let FFmpeg do that once, by 'ffmpeg -i IN OUT'");
  }
  return (static_cast<int>(std::round(quarters)) % 4 + 4) % 4 * 90;
}

AVRational aspect_of(AVFormatContext& format, AVStream& track, AVFrame* frame) {
  const auto aspect = av_guess_sample_aspect_ratio(&format, &track, frame);
  return aspect.num > 0 && aspect.den > 0 ? aspect : AVRational{1, 1};
}

PictureTrack picture_of(const TrackView& view, Survey& survey, Container& container) {
  const auto& track = *view.track;
  const auto& frame = *view.first;
  const auto* format = av_get_pix_fmt_name(static_cast<AVPixelFormat>(frame.format));
  const int order = number_in(track.codecpar->field_order);
  survey.pixel_aspect = aspect_of(container.format(), *view.track, view.first.get());
  PictureTrack made{
      .stored_width = static_cast<std::size_t>(frame.width),
      .stored_height = static_cast<std::size_t>(frame.height),
      .frame_rate = Hertz{survey.times.rate.den > 0 ? av_q2d(survey.times.rate) : 0.0},
      .variable_rate = survey.times.complete && !survey.times.regular,
      .interlaced = frame.interlaced_frame != 0 || order > AV_FIELD_PROGRESSIVE,
      .rotation_degrees = rotation_of(track, container.file()),
      .codec = avcodec_get_name(track.codecpar->codec_id),
      .pixel_format = format != nullptr ? format : "unknown",
      .start = view.start.value_or(Duration{})};
  const double wide = std::round(static_cast<double>(frame.width) * av_q2d(survey.pixel_aspect));
  if (!(wide * static_cast<double>(frame.height) <= static_cast<double>(kMostPicturePixels))) {
    refuse(kDeed,
           container.file(),
           fmt::format("its pixels have the shape {}:{}, so that {} x {} of them would be shown as "
                       "{} x {}",
                       survey.pixel_aspect.num,
                       survey.pixel_aspect.den,
                       frame.width,
                       frame.height,
                       wide,
                       frame.height),
           "convert it to square pixels, e.g. by 'ffmpeg -i IN -vf setsar=1 OUT'");
  }
  made.width = std::max<std::size_t>(static_cast<std::size_t>(wide), 1);
  made.height = made.stored_height;
  if (made.rotation_degrees % 180 != 0) std::swap(made.width, made.height);
  return made;
}

SoundTrack sound_of(const TrackView& view) {
  const auto& frame = *view.first;
  return {.channels = frame.ch_layout.nb_channels,
          .rate = Hertz{static_cast<double>(frame.sample_rate)},
          .codec = avcodec_get_name(view.track->codecpar->codec_id),
          .start = view.start.value_or(Duration{})};
}

/// From the track's start to its end: measured if all packets were seen, else as the header says.
Duration length_of(const TrackView& view, bool whole, const Container& container) {
  const auto start = view.start.value_or(Duration{});
  auto end = view.end.value_or(start);
  // Times of decoding stand for those that the container does not tell; frames are seen later.
  if (!view.complete && view.stored) end += std::max(start - *view.stored, Duration{});
  if (!whole) {
    const auto own = duration_of(view.track->duration, view.track->time_base);
    const auto claimed = own && *own > Duration{} ? own : container.claimed_length();
    if (claimed) end = std::max(end, start + *claimed);
  }
  return std::max(end - start, Duration{});
}

/// A track without a decoder counts as absent.
void look_at(TrackView& view, AVStream* track, const std::filesystem::path& file) {
  if (track == nullptr || avcodec_find_decoder(track->codecpar->codec_id) == nullptr) return;
  view.track = track;
  view.decoder.emplace(file, *track, 1);
}

/// Whether a track was looked through far enough: a minute, and up to `until` if frames are uneven.
class Enough {
 public:
  explicit Enough(Duration until) : until_{until} {}

  [[nodiscard]] bool reached(const TrackView& view) {
    if (!view.reached || !view.start) return false;
    const auto seen = *view.reached - *view.start;
    if (seen <= kLookThrough) return false;
    if (!judged_) {
      const bool video = view.track->codecpar->codec_type == AVMEDIA_TYPE_VIDEO;
      judged_ = true;
      even_ = !video || !view.complete || times_of(view).regular;
    }
    return even_ || seen > until_ + kReordering;
  }

 private:
  Duration until_;
  bool judged_ = false;
  bool even_ = false;  ///< the first minute
};

/// Reads on until the first frames are known and enough was seen. True if the end of the file was
/// reached.
bool look_through(Container& container, TrackView& picture, TrackView& sound, Duration until) {
  const auto packet = new_packet();
  const bool ogg = std::string_view{container.format().iformat->name} == "ogg";
  const auto& leading = picture.track != nullptr ? picture : sound;
  Enough enough{until};
  while (container.read(*packet)) {
    for (auto* view : {&picture, &sound}) {
      if (view->track == nullptr || view->track->index != packet->stream_index) continue;
      keep_first(*view, packet.get());
      note(*view, *packet, ogg);
    }
    if (!picture.waiting() && !sound.waiting() && enough.reached(leading)) return false;
  }
  keep_first(picture, nullptr);
  keep_first(sound, nullptr);
  return true;
}

}  // namespace

Survey survey_of(const std::filesystem::path& file, Duration until) {
  Container container{file};
  TrackView picture;
  TrackView sound;
  look_at(picture, container.picture(), file);
  look_at(sound, container.sound(), file);
  if (picture.track == nullptr && sound.track == nullptr) {
    const auto* track = container.picture() != nullptr ? container.picture() : container.sound();
    const TrackDecoder refused{file, *track, 1};
  }

  Survey survey;
  survey.whole = look_through(container, picture, sound, std::min(until, 2 * kLongestMedia));
  if (!picture.first && !sound.first) {
    refuse("decode",
           file,
           fmt::format("none of its frames can be decoded{}",
                       container.failure() ? " (\"" + *container.failure() + "\")" : ""),
           "copy or convert it again");
  }
  survey.media.container = container.format().iformat->name;
  std::optional<Duration> end;
  const auto include = [&](const TrackView& view, Duration length) {
    const auto start = view.start.value_or(Duration{});
    survey.zero = end ? std::min(survey.zero, start) : start;
    end = std::max(end.value_or(start), start + length);
    return length;
  };
  if (picture.first) {
    survey.times = times_of(picture);
    auto& track = survey.media.picture.emplace(picture_of(picture, survey, container));
    track.length = include(picture, length_of(picture, survey.whole, container));
  }
  if (sound.first) {
    auto& track = survey.media.sound.emplace(sound_of(sound));
    track.length = include(sound, length_of(sound, survey.whole, container));
  }
  survey.media.length = *end - survey.zero;
  if (survey.media.length > kLongestMedia) {
    refuse(kDeed, file, fmt::format("it lasts {}", in_seconds(survey.media.length)), "cut it");
  }
  constexpr Duration kHonest = std::chrono::milliseconds{500};
  const auto claimed = container.claimed_length();
  if (survey.whole && claimed && *claimed > survey.media.length + kHonest) {
    survey.torn_from = survey.media.length;
  }
  return survey;
}

Duration end_within(const Survey& survey,
                    const std::filesystem::path& file,
                    Duration start,
                    Duration end) {
  constexpr Duration kBeyond = std::chrono::milliseconds{50};
  const auto length = survey.media.length;
  if (start < Duration{} || end <= start || start >= length ||
      (end != Duration::max() && end > length + kBeyond)) {
    refuse("take a stretch of",
           file,
           fmt::format("it lasts {}, the stretch is to go from {} to {}{}",
                       in_seconds(length),
                       in_seconds(start),
                       end == Duration::max() ? "the end" : in_seconds(end),
                       survey.torn_from ? " (and its header claims more than it holds)" : ""),
           "choose one within it");
  }
  if (survey.torn_from && end > *survey.torn_from) {
    refuse("decode",
           file,
           fmt::format("it ends after {} although its header claims more",
                       in_seconds(*survey.torn_from)),
           "copy it again, or take a stretch before that");
  }
  return std::min(end, length + kBeyond);
}

}  // namespace bimodal::libav
