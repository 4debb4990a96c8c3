#pragma once

#include <map>
#include <string>
#include <utility>

#include "protocols/model/protocol.hpp"
#include "runner/preparation/enactment.hpp"
#include "runner/preparation/film_cache.hpp"
#include "runner/preparation/frame_source.hpp"
#include "runner/preparation/live_faces.hpp"
#include "runner/preparation/shown_look.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::runner {

/// Makes the films of a protocol's trials: lets the face or the natural talker act, in the look
/// that the condition asks for. Films of the face are taken from a cache, if there is one that has
/// them, and kept there; then nothing is drawn. Belongs to one thread (its faces own OpenGL
/// contexts).
class FilmStudio {
 public:
  /// The first two are borrowed. `quality` is that of every synthetic face.
  FilmStudio(const protocols::Window& window,
             const std::map<std::string, Corpus>& corpora,
             synth::Quality quality,
             std::optional<FilmCache> cache = std::nullopt)
      : window_{window},
        corpora_{corpora},
        quality_{quality},
        cache_{std::move(cache)},
        faces_{quality} {}

  /// Throws Error if the talker cannot be drawn or decoded.
  [[nodiscard]] Film film(const protocols::Condition& condition,
                          const Enactment& enactment,
                          const StimulusLayout& layout,
                          Hertz drawing_rate,
                          const Checkpoint& checkpoint);

  /// The bytes that the film takes in the cache, where it counts as used now; 0 for a natural
  /// talker, who is not drawn; absent if the film is still to be drawn.
  [[nodiscard]] std::optional<std::uintmax_t> kept_bytes(const protocols::Condition& condition,
                                                         const Enactment& enactment,
                                                         const StimulusLayout& layout,
                                                         Hertz drawing_rate);

  /// The room for films in the cache; 0 without one.
  [[nodiscard]] std::uintmax_t room() const { return cache_ ? cache_->most_bytes() : 0; }

  /// Decided once for each condition.
  [[nodiscard]] const ShownLook& look_of(const protocols::Condition& condition);

 private:
  /// Of one condition and enactment.
  struct Scene {
    const ShownLook& look;
    const Enactment& enactment;
    const StimulusLayout& layout;
    Hertz drawing_rate;
    std::optional<Cut> cut;
  };

  [[nodiscard]] Scene scene_of(const protocols::Condition& condition,
                               const Enactment& enactment,
                               const StimulusLayout& layout,
                               Hertz drawing_rate);
  [[nodiscard]] std::string key_of(const Scene& scene, const protocols::Articulating& articulating);

  /// As the cache has it, or drawn and kept.
  [[nodiscard]] Film film_of_face(const Scene& scene,
                                  const protocols::Articulating& articulating,
                                  const Checkpoint& checkpoint);
  [[nodiscard]] Film drawn_film_of_face(const Scene& scene,
                                        const protocols::Articulating& articulating,
                                        const Checkpoint& checkpoint);
  [[nodiscard]] const synth::SegmentTable& table(const std::string& file);

  const protocols::Window& window_;
  const std::map<std::string, Corpus>& corpora_;
  synth::Quality quality_;
  std::optional<FilmCache> cache_;
  std::string drawing_;  ///< drawing_identity(), once it has been asked for
  LiveFaces faces_;
  std::map<std::string, synth::SegmentTable> tables_;  ///< by their files
  std::map<std::string, ShownLook> looks_;             ///< by the condition's name
};

}  // namespace bimodal::runner
