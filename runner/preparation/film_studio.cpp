#include "runner/preparation/film_studio.hpp"

#include "runner/preparation/natural_talker.hpp"
#include "stimuli/timeline/inventory_file.hpp"

namespace bimodal::runner {

const ShownLook& FilmStudio::look_of(const protocols::Condition& condition) {
  const auto known = looks_.find(condition.name);
  if (known != looks_.end()) return known->second;
  return looks_.emplace(condition.name, decide_look(condition, window_, corpora_)).first->second;
}

FaceTalker& FilmStudio::face(const ShownLook& look) {
  auto& face = faces_[{look.lines, look.background}];
  if (!face) face = std::make_unique<FaceTalker>(look.lines, look.background);
  return *face;
}

const synth::SegmentTable& FilmStudio::table(const std::string& file) {
  const auto known = tables_.find(file);
  if (known != tables_.end()) return known->second;
  return tables_.emplace(file, synth::SegmentTable{inventory_file(file)}).first->second;
}

Film FilmStudio::film(const protocols::Condition& condition,
                      const Enactment& enactment,
                      const StimulusLayout& layout,
                      Hertz drawing_rate,
                      const Checkpoint& checkpoint) {
  const auto& look = look_of(condition);
  auto source = enactment.picture_source
                    ? natural_talker(enactment, look.lines, drawing_rate, checkpoint)
                    : face(look).say(enactment.articulation,
                                     table(condition.articulating.segments),
                                     condition.articulating.account);
  const auto shown = with_look(std::move(source), look);
  std::optional<Cut> cut;
  if (enactment.gate) {
    cut = Cut{.at = *enactment.gate,
              .blank = condition.manner.gate->picture == protocols::AfterGate::Blank};
  }
  return make_film(layout, drawing_rate, *shown, checkpoint, cut);
}

}  // namespace bimodal::runner
