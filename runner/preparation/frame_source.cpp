#include "runner/preparation/frame_source.hpp"

#include <algorithm>
#include <map>

namespace bimodal::runner {

Film make_film(const StimulusLayout& layout,
               Hertz drawing_rate,
               FrameSource& source,
               const Checkpoint& checkpoint) {
  Film film;
  std::map<Duration, std::size_t> drawn;
  const auto frames = frame_count(layout, drawing_rate);
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    const auto time =
        std::clamp(frame_time(layout, drawing_rate, frame), Duration{}, layout.recording);
    const auto [found, is_new] = drawn.try_emplace(time, film.pictures.size());
    if (is_new) {
      checkpoint();
      source.paint(time, film.pictures.emplace_back());
    }
    film.picture_of_frame.push_back(found->second);
  }
  return film;
}

}  // namespace bimodal::runner
