#include "runner/preparation/film_studio.hpp"

#include <utility>

#include "runner/preparation/film_key.hpp"
#include "runner/preparation/natural_talker.hpp"
#include "stimuli/timeline/inventory_file.hpp"

namespace bimodal::runner {

const ShownLook& FilmStudio::look_of(const protocols::Condition& condition) {
  const auto known = looks_.find(condition.name);
  if (known != looks_.end()) return known->second;
  return looks_.emplace(condition.name, decide_look(condition, window_, corpora_)).first->second;
}

const synth::SegmentTable& FilmStudio::table(const std::string& file) {
  const auto known = tables_.find(file);
  if (known != tables_.end()) return known->second;
  return tables_.emplace(file, synth::SegmentTable{inventory_file(file)}).first->second;
}

Film FilmStudio::drawn_film_of_face(const Scene& scene,
                                    const protocols::Articulating& articulating,
                                    const Checkpoint& checkpoint) {
  auto talker = faces_.face(scene.look)
                    .say(scene.enactment.articulation,
                         table(articulating.segments),
                         articulating.account,
                         bearing_of(scene.look.face));
  const auto shown = with_look(std::move(talker), scene.look);
  return make_film(scene.layout, scene.drawing_rate, *shown, checkpoint, scene.cut);
}

FilmStudio::Scene FilmStudio::scene_of(const protocols::Condition& condition,
                                       const Enactment& enactment,
                                       const StimulusLayout& layout,
                                       Hertz drawing_rate) {
  std::optional<Cut> cut;
  if (enactment.gate) {
    cut = Cut{.at = *enactment.gate,
              .blank = condition.manner.gate->picture == protocols::AfterGate::Blank};
  }
  return {look_of(condition), enactment, layout, drawing_rate, cut};
}

std::string FilmStudio::key_of(const Scene& scene, const protocols::Articulating& articulating) {
  if (drawing_.empty()) drawing_ = drawing_identity();
  return film_key({.drawing = drawing_,
                   .articulation = scene.enactment.articulation,
                   .table_sha256 = table(articulating.segments).sha256(),
                   .account = articulating.account,
                   .look = scene.look,
                   .quality = quality_,
                   .layout = scene.layout,
                   .drawing_rate = scene.drawing_rate,
                   .cut = scene.cut});
}

Film FilmStudio::film_of_face(const Scene& scene,
                              const protocols::Articulating& articulating,
                              const Checkpoint& checkpoint) {
  if (!cache_) return drawn_film_of_face(scene, articulating, checkpoint);
  const auto key = key_of(scene, articulating);
  if (auto kept = cache_->find(key, checkpoint)) return std::move(*kept);
  auto film = drawn_film_of_face(scene, articulating, checkpoint);
  cache_->keep(key, film, checkpoint);
  return film;
}

Film FilmStudio::film(const protocols::Condition& condition,
                      const Enactment& enactment,
                      const StimulusLayout& layout,
                      Hertz drawing_rate,
                      const Checkpoint& checkpoint) {
  const auto scene = scene_of(condition, enactment, layout, drawing_rate);
  if (!enactment.picture_source) return film_of_face(scene, condition.articulating, checkpoint);
  const auto shown =
      with_look(natural_talker(enactment, scene.look.lines, drawing_rate, checkpoint), scene.look);
  return make_film(layout, drawing_rate, *shown, checkpoint, scene.cut);
}

std::optional<std::uintmax_t> FilmStudio::kept_bytes(const protocols::Condition& condition,
                                                     const Enactment& enactment,
                                                     const StimulusLayout& layout,
                                                     Hertz drawing_rate) {
  if (enactment.picture_source) return 0;
  if (!cache_) return std::nullopt;
  const auto scene = scene_of(condition, enactment, layout, drawing_rate);
  return cache_->use(key_of(scene, condition.articulating));
}

}  // namespace bimodal::runner
