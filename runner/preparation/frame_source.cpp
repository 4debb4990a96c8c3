#include "runner/preparation/frame_source.hpp"

#include <algorithm>
#include <map>

namespace bimodal::runner {

Film make_film(const StimulusLayout& layout,
               Hertz drawing_rate,
               FrameSource& source,
               const Checkpoint& checkpoint,
               const std::optional<Cut>& cut) {
  Film film;
  std::map<std::int64_t, std::size_t> drawn;
  const auto frames = frame_count(layout, drawing_rate);
  const Duration latest =
      cut && !cut->blank ? std::min(cut->at, layout.recording) : layout.recording;
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    const auto shown_at = frame_time(layout, drawing_rate, frame);
    if (cut && cut->blank && shown_at >= cut->at) {
      film.picture_of_frame.push_back(Film::kBlank);
      continue;
    }
    const auto time = std::clamp(shown_at, Duration{}, latest);
    const auto number = source.picture_at(time);
    const auto [found, is_new] = drawn.try_emplace(number, film.pictures.size());
    if (is_new) {
      checkpoint();
      film.pictures.push_back(source.paint(time));
      if (const auto origin = source.source_frame(number)) {
        film.source_frame_of_picture.push_back(*origin);
      }
    }
    film.picture_of_frame.push_back(found->second);
  }
  return film;
}

}  // namespace bimodal::runner
