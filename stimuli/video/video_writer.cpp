#include "stimuli/video/video_writer.hpp"

#include <algorithm>
#include <cassert>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "stimuli/video/container_writer.hpp"
#include "stimuli/video/picture_encoder.hpp"
#include "stimuli/video/picture_queue.hpp"
#include "stimuli/video/sound_encoder.hpp"

namespace bimodal {

namespace {

constexpr std::size_t kLargestSide = 8192;
constexpr std::int64_t kAacBits = 160'000;  ///< a second
constexpr std::int64_t kOpusBits = 128'000;

const VideoForm& judged(const std::filesystem::path& file, const VideoOptions& options) {
  const auto refuse = [&](std::string_view finding, std::string_view remedy) {
    libav::refuse("write", file, finding, remedy);
  };
  const auto* const form = video_form_of(file);
  if (form == nullptr) {
    std::vector<std::string_view> endings;
    for (const auto& known : video_forms()) endings.push_back(known.ending);
    refuse(fmt::format("videos are written as {}", fmt::join(endings, ", ")), "end its name so");
  }
  const bool is_usable = options.width > 0 && options.height > 0 && options.width % 2 == 0 &&
                         options.height % 2 == 0 &&
                         std::max(options.width, options.height) <= kLargestSide;
  if (!is_usable) {
    refuse(fmt::format("{} x {} pixels are no size for a video", options.width, options.height),
           fmt::format("give even numbers up to {}", kLargestSide));
  }
  if (options.sound != nullptr && !form->has_sound) {
    refuse("a GIF has no sound", "write .mp4 or .webm, or leave the sound out");
  }
  if (rate_in(*form, options.rate) != options.rate) {
    refuse(fmt::format("{} frames a second cannot be had in this form", describe(options.rate)),
           fmt::format("take {}", describe(rate_in(*form, options.rate))));
  }
  if (!options.rate_factor) return *form;
  if (!form->factor) refuse("it has no constant rate factor", "leave it out");
  if (*options.rate_factor < 0 || *options.rate_factor > form->factor->coarsest) {
    refuse(fmt::format("{} is no constant rate factor of this form", *options.rate_factor),
           fmt::format("take one from 0 to {}", form->factor->coarsest));
  }
  return *form;
}

}  // namespace

struct VideoWriter::Tracks {
  libav::ContainerWriter container;
  std::unique_ptr<libav::PictureEncoder> pictures;
  std::optional<libav::SoundEncoder> sound;
  FrameRate rate;
  std::int64_t count = 0;
  std::optional<PictureQueue> queue;  ///< its thread encodes until it is finished

  Tracks(const std::filesystem::path& file, const VideoForm& form, const VideoOptions& options)
      : container{file, form.ending.substr(1)}, rate{options.rate} {
    const bool is_mp4 = form.ending == ".mp4";
    pictures = form.is_gif ? libav::palette_encoder(container, form, options)
                           : libav::film_encoder(container, form, options);
    if (options.sound != nullptr) {
      sound.emplace(
          container, is_mp4 ? "aac" : "libopus", is_mp4 ? kAacBits : kOpusBits, *options.sound);
    }
    container.begin();
    queue.emplace([this](const Image& picture) { encode(picture); });
  }

  void encode(const Image& picture) {
    if (sound) sound->encode_until(rate.time_of(count));
    pictures->add(picture);
    ++count;
  }
};

VideoWriter::VideoWriter(const std::filesystem::path& file, const VideoOptions& options)
    : tracks_{std::make_unique<Tracks>(file, judged(file, options), options)} {}

VideoWriter::~VideoWriter() = default;

void VideoWriter::add(const Image& picture) {
  tracks_->queue->add(picture);
}

void VideoWriter::finish() {
  auto& tracks = *tracks_;
  tracks.queue->finish();
  tracks.pictures->finish();
  if (tracks.sound) tracks.sound->finish();
  tracks.container.finish();
}

}  // namespace bimodal
