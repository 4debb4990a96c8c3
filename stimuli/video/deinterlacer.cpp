#include "stimuli/video/deinterlacer.hpp"

#include <new>

#include <fmt/format.h>

extern "C" {
#include <libavfilter/buffersink.h>
#include <libavfilter/buffersrc.h>
}

namespace bimodal::libav {

namespace {

constexpr auto kOptions = "mode=send_frame:parity=auto:deint=interlaced";
constexpr int kThreads = 2;

}  // namespace

Deinterlacer::Deinterlacer(const std::filesystem::path& file, const AVFrame& like, AVRational unit)
    : file_{file}, graph_{avfilter_graph_alloc()} {
  if (!graph_) throw std::bad_alloc{};
  graph_->nb_threads = kThreads;
  const auto shape = fmt::format("video_size={}x{}:pix_fmt={}:time_base={}/{}:pixel_aspect=1/1",
                                 like.width,
                                 like.height,
                                 like.format,
                                 unit.num,
                                 unit.den);
  AVFilterContext* filter = nullptr;
  const auto make = [&](AVFilterContext** made, const char* name, const char* options) {
    return avfilter_graph_create_filter(
        made, avfilter_get_by_name(name), name, options, nullptr, graph_.get());
  };
  int outcome = make(&source_, "buffer", shape.c_str());
  if (outcome >= 0) outcome = make(&filter, "bwdif", kOptions);
  if (outcome >= 0) outcome = make(&sink_, "buffersink", nullptr);
  if (outcome >= 0) outcome = avfilter_link(source_, 0, filter, 0);
  if (outcome >= 0) outcome = avfilter_link(filter, 0, sink_, 0);
  if (outcome >= 0) outcome = avfilter_graph_config(graph_.get(), nullptr);
  if (outcome < 0) {
    refuse("deinterlace",
           file,
           fmt::format("FFmpeg says \"{}\"", words_of(outcome)),
           "deinterlace it by another program");
  }
}

void Deinterlacer::push(AVFrame* frame) {
  const int outcome = av_buffersrc_add_frame(source_, frame);
  if (outcome < 0) {
    refuse("deinterlace",
           file_,
           fmt::format("FFmpeg says \"{}\"", words_of(outcome)),
           "deinterlace it by another program");
  }
}

bool Deinterlacer::pull(AVFrame& frame) {
  return av_buffersink_get_frame(sink_, &frame) >= 0;
}

}  // namespace bimodal::libav
