#include "runner/cli/session_preparation.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "runner/cli/sound_check.hpp"
#include "runner/preparation/films_ahead.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

PreparationQueue::Prepare prepare_session(const SessionPreparation& session) {
  struct Workshop {
    std::optional<FilmStudio> studio;
    std::optional<TrialPreparer> preparer;
    bool draws_ahead = false;
  };

  const auto& protocol = session.read.protocol;
  auto workshop = std::make_shared<Workshop>();
  std::optional<FilmCache> cache;
  const auto folder = film_cache_folder();
  if (folder && session.keeps_films) cache.emplace(*folder);
  workshop->draws_ahead = cache && draws_too_slowly(session.quality);
  workshop->studio.emplace(
      protocol.window, session.read.corpora, session.quality.quality, std::move(cache));
  workshop->preparer.emplace(
      protocol, session.repertoire, &*workshop->studio, session.drawing_rate);
  const auto found = check_sounds(session.read, session.plan, *workshop->preparer, session.named);
  if (has_errors(found)) throw Error{describe(found.front())};
  return [workshop, session](const protocols::PlannedTrial& trial, const Checkpoint& checkpoint) {
    if (std::exchange(workshop->draws_ahead, false)) {
      draw_films_ahead(session.plan,
                       *workshop->preparer,
                       workshop->studio->room(),
                       film_time(*session.quality.pace),
                       checkpoint,
                       session.tell);
    }
    return workshop->preparer->prepare(trial, checkpoint);
  };
}

}  // namespace bimodal::runner
