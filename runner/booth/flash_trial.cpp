#include "runner/booth/flash_trial.hpp"

#include <cmath>
#include <memory>
#include <numbers>

namespace bimodal::runner {

namespace {

constexpr int kLevels = 4;
constexpr double kBeepFrequency = 1000.0;  // Hz

std::shared_ptr<const Image> picture(int size, std::uint8_t left, std::uint8_t right) {
  auto image = std::make_shared<Image>();
  image->width = image->height = static_cast<std::size_t>(size);
  image->pixels.resize(4 * image->width * image->height);
  for (std::size_t i = 0; i < image->pixels.size(); ++i) {
    const auto column = i / 4 % image->width;
    image->pixels[i] = i % 4 == 3 ? 255 : (column < image->width / 2 ? left : right);
  }
  return image;
}

/// It begins with a cosine, so that its first sample is its largest.
Sound beep(const FlashTrial& flash) {
  const auto count = static_cast<std::size_t>(nearest_sample(flash.beep, flash.sound_rate).count());
  auto samples = std::make_shared<std::vector<float>>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double phase =
        2.0 * std::numbers::pi * kBeepFrequency * static_cast<double>(i) / flash.sound_rate.count();
    (*samples)[i] = static_cast<float>(flash.level * std::cos(phase));
  }
  return {.rate = flash.sound_rate, .samples = std::move(samples)};
}

}  // namespace

int frame_level(std::int64_t frame) {
  return static_cast<int>(255 * (frame % kLevels) / (kLevels - 1));
}

PreparedTrial make_flash_trial(const FlashTrial& flash) {
  PreparedTrial trial;
  trial.layout = {.recording = flash.flash,
                  .lead = flash.lead,
                  .trail = flash.trail,
                  .av_offset = flash.av_offset,
                  .has_sound = true};
  trial.drawing_rate = flash.drawing_rate;
  trial.frames = frame_count(trial.layout, flash.drawing_rate);
  trial.sound = beep(flash);
  Film film;
  for (const bool is_white : {false, true}) {
    for (int level = 0; level < kLevels; ++level) {
      film.pictures.push_back(
          picture(flash.size, is_white ? 255 : 0, static_cast<std::uint8_t>(frame_level(level))));
    }
  }
  for (std::int64_t frame = 0; frame < trial.frames; ++frame) {
    const auto time = frame_time(trial.layout, flash.drawing_rate, frame);
    const bool is_white = time >= Duration::zero() && time < flash.flash;
    film.picture_of_frame.push_back(static_cast<std::size_t>(frame % kLevels) +
                                    (is_white ? kLevels : 0));
  }
  trial.film = std::move(film);
  return trial;
}

}  // namespace bimodal::runner
