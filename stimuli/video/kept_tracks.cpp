#include "stimuli/video/kept_tracks.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "stimuli/audio/resample.hpp"

namespace bimodal {

Clip KeptTracks::read(const std::filesystem::path& file, Hertz rate, MediaSpan span) {
  const auto* const whole = track_of(file);
  if (whole != nullptr && span.start >= Duration{} && span.start < span.end &&
      span.end <= whole->duration()) {
    const auto sample = [&](Duration time) { return nearest_sample(time, whole->rate).count(); };
    const auto begin = whole->samples.begin();
    const auto end = std::min<std::int64_t>(sample(span.end), std::ssize(whole->samples));
    const Clip stretch{whole->rate, {begin + sample(span.start), begin + end}};
    return rate == Hertz{0} ? stretch : resample(stretch, rate);
  }
  return read_sound_track(file, rate, span);
}

const Media& KeptTracks::media_of(const std::filesystem::path& file) {
  const auto known = media_.find(file);
  return known != media_.end() ? known->second
                               : media_.emplace(file, examine_media(file)).first->second;
}

const Clip* KeptTracks::track_of(const std::filesystem::path& file) {
  const auto known = std::ranges::find(tracks_, file, &Track::file);
  if (known != tracks_.end()) {
    tracks_.splice(tracks_.begin(), tracks_, known);
    return &tracks_.front().sound;
  }
  const auto& media = media_of(file);
  if (!media.sound) return nullptr;
  const double seconds = std::chrono::duration<double>{media.length}.count();
  if (seconds * media.sound->rate.count() > static_cast<double>(most_samples_)) return nullptr;
  tracks_.push_front({file, read_sound_track(file)});
  ++decoded_;
  const auto kept = [&] {
    return std::accumulate(
        tracks_.begin(), tracks_.end(), std::size_t{0}, [](std::size_t sum, const Track& track) {
          return sum + track.sound.samples.size();
        });
  };
  while (tracks_.size() > 1 && kept() > most_samples_) tracks_.pop_back();
  return &tracks_.front().sound;
}

}  // namespace bimodal
