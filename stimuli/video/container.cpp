#include "stimuli/video/container.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>

extern "C" {
#include <libavutil/dict.h>
#include <libavutil/log.h>
#include <libavutil/mathematics.h>
}

#include "stimuli/video/media_file.hpp"

namespace bimodal::libav {

namespace {

constexpr auto kDeed = "read";
constexpr unsigned kMostProbeBytes = 1U << 20U;
constexpr int kMostTracks = 64;
/// Even raw sound in packets of a millisecond has no more in kLongestMedia; each packet has a byte.
constexpr std::int64_t kMostPackets = 4LL * kLongestMedia / std::chrono::milliseconds{1};

/// Whatever else a file wants to open is none of its business.
int open_nothing(AVFormatContext*, AVIOContext**, const char*, int, AVDictionary**) {
  return AVERROR(EPERM);
}

/// Formats that are lists of other files, or where text is drawn.
constexpr std::array<std::string_view, 10> kRefusedFormats{
    "concat", "hls", "dash", "imf", "sdp", "rtp", "rtsp", "tty", "lavfi", "webm_dash_manifest"};

const AVInputFormat* recognise(const BoundedInput& input, const std::filesystem::path& file) {
  const AVInputFormat* found = nullptr;
  const auto name = file.filename().string();
  const int score =
      av_probe_input_buffer2(input.context(), &found, name.c_str(), nullptr, 0, kMostProbeBytes);
  if (score < 0 || found == nullptr) {
    refuse(kDeed, file, "it is no sound or video file that FFmpeg knows", "name a recording");
  }
  const std::string_view format = found->name;
  if (format == "image2" || format.ends_with("_pipe")) {
    refuse(kDeed, file, "it is a still picture", "name a video");
  }
  if (std::ranges::find(kRefusedFormats, format) != kRefusedFormats.end()) {
    refuse(kDeed,
           file,
           fmt::format("it is a list or a text ('{}'), not a recording itself", found->name),
           "name the recording");
  }
  return found;
}

/// Options of the decoders with which FFmpeg looks at the first frames.
class ProbeOptions {
 public:
  explicit ProbeOptions(unsigned tracks) : options_(tracks, nullptr) {
    for (auto*& option : options_) {
      av_dict_set(&option, "threads", "1", 0);
      av_dict_set_int(&option, "max_pixels", static_cast<std::int64_t>(kMostPicturePixels), 0);
    }
  }

  ProbeOptions(const ProbeOptions&) = delete;
  ProbeOptions& operator=(const ProbeOptions&) = delete;
  ProbeOptions(ProbeOptions&&) = delete;
  ProbeOptions& operator=(ProbeOptions&&) = delete;

  ~ProbeOptions() {
    for (auto*& option : options_) av_dict_free(&option);
  }

  [[nodiscard]] AVDictionary** pointer() { return options_.empty() ? nullptr : options_.data(); }

 private:
  std::vector<AVDictionary*> options_;
};

FormatContext opened(const BoundedInput& input, const std::filesystem::path& file) {
  const auto* kind = recognise(input, file);
  AVFormatContext* format = avformat_alloc_context();
  if (format == nullptr) throw std::bad_alloc{};
  format->pb = input.context();
  format->io_open = &open_nothing;
  format->max_streams = kMostTracks;
  AVDictionary* options = nullptr;
  av_dict_set(&options, "protocol_whitelist", "none", 0);
  const int opened = avformat_open_input(&format, file.filename().c_str(), kind, &options);
  av_dict_free(&options);
  if (opened < 0) {  // the context is then already gone
    refuse(kDeed,
           file,
           fmt::format("FFmpeg takes it for '{}' and says \"{}\"", kind->name, words_of(opened)),
           "check that it is a whole recording, copy or convert it again");
  }
  FormatContext made{format};
  ProbeOptions probing{made->nb_streams};
  const int looked = avformat_find_stream_info(made.get(), probing.pointer());
  if (looked < 0) {
    refuse(kDeed,
           file,
           fmt::format("nothing in it can be decoded (\"{}\")", words_of(looked)),
           "copy or convert it again");
  }
  return made;
}

bool is_cover(const AVStream& track) {
  return (track.disposition & (AV_DISPOSITION_ATTACHED_PIC | AV_DISPOSITION_TIMED_THUMBNAILS)) != 0;
}

AVStream* track_of(const AVFormatContext& format, AVMediaType type) {
  AVStream* first = nullptr;
  for (auto* track : std::span{format.streams, format.nb_streams}) {
    if (track->codecpar->codec_type != type || is_cover(*track)) continue;
    if ((track->disposition & AV_DISPOSITION_DEFAULT) != 0) return track;
    if (first == nullptr) first = track;
  }
  return first;
}

bool has_cover(const AVFormatContext& format) {
  return std::ranges::any_of(std::span{format.streams, format.nb_streams},
                             [](const AVStream* track) { return is_cover(*track); });
}

void require_size(const AVStream& picture, const std::filesystem::path& file) {
  const auto& shape = *picture.codecpar;
  const auto width = static_cast<std::uint64_t>(std::max(shape.width, 0));
  const auto height = static_cast<std::uint64_t>(std::max(shape.height, 0));
  if (width * height <= kMostPicturePixels) return;
  refuse(kDeed,
         file,
         fmt::format("its picture has {} x {} pixels", width, height),
         "make it smaller, e.g. by 'ffmpeg -i IN -vf scale=-2:1080 OUT'");
}

}  // namespace

Container::Container(const std::filesystem::path& file)
    : file_{file}, input_{file}, packets_left_{std::min(kMostPackets, input_.size() + 1000)} {
  libav::be_silent();
  format_ = opened(input_, file);
  picture_ = track_of(*format_, AVMEDIA_TYPE_VIDEO);
  sound_ = track_of(*format_, AVMEDIA_TYPE_AUDIO);
  if (picture_ == nullptr && sound_ == nullptr) {
    refuse(kDeed,
           file,
           has_cover(*format_) ? "it has a cover, but neither sound nor moving picture"
                               : "it has neither sound nor picture",
           "name a recording");
  }
  if (picture_ != nullptr) require_size(*picture_, file);
  for (auto* track : std::span{format_->streams, format_->nb_streams}) {
    if (track != picture_ && track != sound_) track->discard = AVDISCARD_ALL;
  }
  const auto length = claimed_length();
  if (length && *length > kLongestMedia) {
    refuse(kDeed,
           file,
           fmt::format("it lasts {}", in_seconds(*length)),
           fmt::format("cut it into pieces of at most {}", in_seconds(kLongestMedia)));
  }
}

void Container::read_only(const AVStream& track) {
  for (auto* other : std::span{format_->streams, format_->nb_streams}) {
    if (other != &track) other->discard = AVDISCARD_ALL;
  }
}

bool Container::read(AVPacket& packet) {
  while (packets_left_-- > 0) {
    av_packet_unref(&packet);
    const int outcome = av_read_frame(format_.get(), &packet);
    if (outcome == AVERROR_EOF) return false;
    if (outcome < 0) {
      failure_ = words_of(outcome);
      return false;
    }
    const auto* track = format_->streams[packet.stream_index];
    if (track->discard != AVDISCARD_ALL && (track == picture_ || track == sound_)) return true;
  }
  failure_ = "more packets than bytes";
  return false;
}

bool Container::seek(const AVStream& track, Duration time) {
  constexpr AVRational kNanosecond{.num = 1, .den = 1'000'000'000};
  const auto stamp = av_rescale_q(time.count(), kNanosecond, track.time_base);
  return av_seek_frame(format_.get(), track.index, stamp, AVSEEK_FLAG_BACKWARD) >= 0;
}

std::optional<Duration> Container::claimed_length() const {
  if (format_->duration_estimation_method == AVFMT_DURATION_FROM_BITRATE) return std::nullopt;
  const auto others = std::ranges::any_of(
      std::span{format_->streams, format_->nb_streams},
      [&](const auto* track) { return track != picture_ && track != sound_ && !is_cover(*track); });
  if (others) return std::nullopt;
  constexpr AVRational kMicrosecond{1, AV_TIME_BASE};
  const auto length = duration_of(format_->duration, kMicrosecond);
  // Of all formats, Matroska's length is that from the zero of its clock.
  const auto start = duration_of(format_->start_time, kMicrosecond);
  const bool from_zero = std::string_view{format_->iformat->name}.starts_with("matroska");
  if (!length || !start || !from_zero) return length;
  return *length - std::max(*start, Duration{});
}

}  // namespace bimodal::libav
