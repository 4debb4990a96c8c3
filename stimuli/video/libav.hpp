#pragma once

#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavfilter/avfilter.h>
#include <libavformat/avformat.h>
#include <libswscale/swscale.h>
}

#include "stimuli/base/quantity.hpp"

/// What the files of this folder share: ownership of FFmpeg's objects, its times and error codes in
/// ours. Only they include this.
namespace bimodal::libav {

/// Calls one of FFmpeg's functions that take the address of a pointer.
template <auto kRelease>
struct Release {
  template <typename Object>
  void operator()(Object* object) const {
    kRelease(&object);
  }
};

struct FreeScaler {
  void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};

using CodecContext = std::unique_ptr<AVCodecContext, Release<&avcodec_free_context>>;
using FilterGraph = std::unique_ptr<AVFilterGraph, Release<&avfilter_graph_free>>;
using FormatContext = std::unique_ptr<AVFormatContext, Release<&avformat_close_input>>;
using Frame = std::unique_ptr<AVFrame, Release<&av_frame_free>>;
using Packet = std::unique_ptr<AVPacket, Release<&av_packet_free>>;
using Scaler = std::unique_ptr<SwsContext, FreeScaler>;

/// Empty ones; std::bad_alloc if there is no memory.
[[nodiscard]] Frame new_frame();
[[nodiscard]] Packet new_packet();

/// A time stamp in nanoseconds, rounded; absent if FFmpeg does not know it or it is beyond 30
/// years, which no recording is (and so that differences of two of them can be formed).
[[nodiscard]] std::optional<Duration> duration_of(std::int64_t stamp, AVRational unit);

/// An enumeration's number as FFmpeg has read it from a file, which may be none of its values (and
/// then C++ does not define what loading it as the enumeration does).
template <typename Enumeration>
[[nodiscard]] int number_in(const Enumeration& from_file) {
  int number = 0;
  static_assert(sizeof number == sizeof from_file);
  std::memcpy(&number, &from_file, sizeof number);
  return number;
}

/// FFmpeg would print to the terminal; what matters is in our messages.
void be_silent();

/// FFmpeg's own words for one of its error codes.
[[nodiscard]] std::string words_of(int code);

/// E.g. "1.240 s".
[[nodiscard]] std::string in_seconds(Duration time);

/// Throws Error: cannot `deed` 'file': `finding`; `remedy`.
[[noreturn]] void refuse(std::string_view deed,
                         const std::filesystem::path& file,
                         std::string_view finding,
                         std::string_view remedy);

}  // namespace bimodal::libav
