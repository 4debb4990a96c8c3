#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "protocols/design/plan.hpp"
#include "runner/preparation/trial_preparer.hpp"

namespace bimodal::runner {

/// Draws, before a session's first trial, the films of the face that the studio's cache does not
/// hold yet, so that nobody waits for them between trials. It stops when the session's films fill
/// most of the cache: more would drive out the first ones. `film_time` is what one is expected to
/// take; `announce` is told what is done, how long it will take, and how far it is. Belongs to the
/// thread of `preparer`; `checkpoint` is called between pictures.
void draw_films_ahead(const std::vector<protocols::PlannedTrial>& plan,
                      TrialPreparer& preparer,
                      std::uintmax_t room,
                      Duration film_time,
                      const Checkpoint& checkpoint,
                      const std::function<void(std::string_view)>& announce);

/// "less than a minute", "about 3 minutes".
[[nodiscard]] std::string about_minutes(Duration duration);

}  // namespace bimodal::runner
