#include <algorithm>
#include <cstring>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "stimuli/video/picture_encoder.hpp"

extern "C" {
#include <libavfilter/buffersink.h>
#include <libavfilter/buffersrc.h>
}

namespace bimodal::libav {

namespace {

constexpr int kPaletteSide = 16;

/// One of FFmpeg's chains of filters. Sources and sink are found by their names in the description.
class Filters {
 public:
  Filters(const ContainerWriter& container, const std::string& description)
      : container_{container}, graph_{avfilter_graph_alloc()} {
    if (!graph_) throw std::bad_alloc{};
    graph_->nb_threads = 1;
    AVFilterInOut* open_inputs = nullptr;
    AVFilterInOut* open_outputs = nullptr;
    container.judge(
        avfilter_graph_parse2(graph_.get(), description.c_str(), &open_inputs, &open_outputs));
    avfilter_inout_free(&open_inputs);
    avfilter_inout_free(&open_outputs);
    container.judge(avfilter_graph_config(graph_.get(), nullptr));
  }

  /// Takes what the frame holds; nullptr: there are no more.
  void push(const char* source, AVFrame* frame) {
    container_.judge(av_buffersrc_add_frame(named(source), frame));
  }

  /// False if more must be pushed before, or all have come.
  bool pull(AVFrame& frame) {
    const int code = av_buffersink_get_frame(named("buffersink@out"), &frame);
    if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return false;
    container_.judge(code);
    return true;
  }

 private:
  AVFilterContext* named(const char* name) { return avfilter_graph_get_filter(graph_.get(), name); }

  const ContainerWriter& container_;
  FilterGraph graph_;
};

std::string source_of(const char* name, std::size_t width, std::size_t height, const char* pixels) {
  return fmt::format("buffer@{}=video_size={}x{}:pix_fmt={}:time_base=1/100:pixel_aspect=1/1",
                     name,
                     width,
                     height,
                     pixels);
}

class PaletteEncoder final : public PictureEncoder {
 public:
  PaletteEncoder(ContainerWriter& container, const VideoForm& form, const VideoOptions& options)
      : container_{container},
        options_{options},
        most_{most_frames(form, options.width, options.height)},
        track_{container, opened(container, options)} {}

  void add(const Image& picture) override {
    if (static_cast<std::int64_t>(pictures_.size()) == most_) {
      container_.refuse(fmt::format("a GIF of {} x {} pixels has {} frames at most",
                                    options_.width,
                                    options_.height,
                                    most_),
                        "take fewer or smaller ones, or write .mp4 or .webm");
    }
    pictures_.push_back(picture);
  }

  void finish() override {
    if (!pictures_.empty()) encode_in(palette());
    track_.encode(nullptr);
  }

 private:
  static CodecContext opened(const ContainerWriter& container, const VideoOptions& options) {
    auto codec = container.encoder("gif");
    codec->width = static_cast<int>(options.width);
    codec->height = static_cast<int>(options.height);
    codec->pix_fmt = AV_PIX_FMT_PAL8;
    codec->framerate = {.num = static_cast<int>(options.rate.pictures),
                        .den = static_cast<int>(options.rate.seconds)};
    codec->time_base = av_inv_q(codec->framerate);
    return codec;
  }

  Frame frame_of(std::size_t number) {
    const auto& picture = pictures_[number];
    auto frame = new_frame();
    frame->format = AV_PIX_FMT_RGB0;
    frame->width = static_cast<int>(picture.width);
    frame->height = static_cast<int>(picture.height);
    frame->pts = static_cast<std::int64_t>(number);
    container_.judge(av_frame_get_buffer(frame.get(), 0));
    const auto row = picture.width * 4;
    for (std::size_t y = 0; y < picture.height; ++y) {
      std::memcpy(frame->data[0] + static_cast<std::ptrdiff_t>(y) * frame->linesize[0],
                  picture.pixels.data() + y * row,
                  row);
    }
    return frame;
  }

  [[nodiscard]] std::string pictures_source() const {
    return source_of("pictures", options_.width, options_.height, "rgb0");
  }

  Frame palette() {
    Filters choosing{container_, pictures_source() + ",palettegen,buffersink@out"};
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
      choosing.push("buffer@pictures", frame_of(i).get());
    }
    choosing.push("buffer@pictures", nullptr);
    auto chosen = new_frame();
    if (!choosing.pull(*chosen)) container_.refuse("FFmpeg finds no colours", "write .mp4");
    return chosen;
  }

  void encode_in(Frame palette) {
    Filters colouring{
        container_,
        fmt::format("{}[pictures];{}[palette];[pictures][palette]paletteuse=dither=bayer:"
                    "bayer_scale=3,buffersink@out",
                    pictures_source(),
                    source_of("palette", kPaletteSide, kPaletteSide, "bgra"))};
    palette->pts = 0;
    colouring.push("buffer@palette", palette.get());
    colouring.push("buffer@palette", nullptr);
    const auto coloured = new_frame();
    const auto encode_what_is_done = [&] {
      while (colouring.pull(*coloured)) {
        coloured->pts = count_++;
        track_.encode(coloured.get());
        av_frame_unref(coloured.get());
      }
    };
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
      colouring.push("buffer@pictures", frame_of(i).get());
      encode_what_is_done();
    }
    colouring.push("buffer@pictures", nullptr);
    encode_what_is_done();
  }

  ContainerWriter& container_;
  VideoOptions options_;
  std::int64_t most_;
  EncodedTrack track_;
  std::vector<Image> pictures_;
  std::int64_t count_ = 0;
};

}  // namespace

std::unique_ptr<PictureEncoder> palette_encoder(ContainerWriter& container,
                                                const VideoForm& form,
                                                const VideoOptions& options) {
  return std::make_unique<PaletteEncoder>(container, form, options);
}

}  // namespace bimodal::libav
