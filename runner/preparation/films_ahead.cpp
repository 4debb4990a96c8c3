#include "runner/preparation/films_ahead.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "runner/devices/monotonic_clock.hpp"
#include "stimuli/base/counted.hpp"

namespace bimodal::runner {

namespace {

/// So many times on the way it is said how far it is.
constexpr std::size_t kAnnouncements = 10;

/// Of the cache: the rest is for the films that the session draws besides.
constexpr std::uintmax_t most_of(std::uintmax_t room) {
  return room / 4 * 3;
}

/// Films of one condition after each other, as far as trials of one stretch go: a face of another
/// look takes time to make, and none of the first trials shall wait for all of the last ones.
void bring_looks_together(std::vector<const protocols::PlannedTrial*>& trials) {
  constexpr std::size_t kStretch = 24;
  for (std::size_t begin = 0; begin < trials.size(); begin += kStretch) {
    const auto stretch =
        std::span{trials}.subspan(begin).first(std::min(kStretch, trials.size() - begin));
    std::ranges::stable_sort(
        stretch, {}, [](const protocols::PlannedTrial* trial) { return trial->condition; });
  }
}

}  // namespace

std::string about_minutes(Duration duration) {
  const auto minutes = std::chrono::duration<double, std::ratio<60>>{duration}.count();
  if (minutes < 1.0) return "less than a minute";
  return "about " + counted(static_cast<std::size_t>(std::lround(minutes)), "minute");
}

void draw_films_ahead(const std::vector<protocols::PlannedTrial>& plan,
                      TrialPreparer& preparer,
                      std::uintmax_t room,
                      Duration film_time,
                      const Checkpoint& checkpoint,
                      const std::function<void(std::string_view)>& announce) {
  std::uintmax_t kept = 0;
  std::vector<const protocols::PlannedTrial*> lacking;
  for (const auto& trial : plan) {
    checkpoint();
    if (const auto bytes = preparer.kept_film_bytes(trial)) {
      kept += *bytes;
    } else {
      lacking.push_back(&trial);
    }
  }
  if (lacking.empty()) return;
  bring_looks_together(lacking);
  announce(fmt::format("drawing {} of the face before the first trial: {}; kept for later sessions",
                       counted(lacking.size(), "film"),
                       about_minutes(film_time * static_cast<std::int64_t>(lacking.size()))));
  const MonotonicClock clock;
  const auto begin = clock.now();
  for (std::size_t drawn = 1; drawn <= lacking.size(); ++drawn) {
    const auto& trial = *lacking[drawn - 1];
    static_cast<void>(preparer.prepare(trial, checkpoint));
    const auto bytes = preparer.kept_film_bytes(trial);
    if (!bytes) {
      announce("films cannot be kept (is the disk full?): each is drawn before its trial");
      return;
    }
    kept += *bytes;
    if (drawn == lacking.size()) break;
    if (kept > most_of(room)) {
      announce(
          fmt::format("drawn {} of {} films, and no room is left for more: the others are "
                      "drawn before their trials",
                      drawn,
                      lacking.size()));
      return;
    }
    if (drawn * kAnnouncements / lacking.size() == (drawn - 1) * kAnnouncements / lacking.size()) {
      continue;
    }
    const auto each = (clock.now() - begin) / static_cast<std::int64_t>(drawn);
    announce(fmt::format("drawn {} of {} films; {} left",
                         drawn,
                         lacking.size(),
                         about_minutes(each * static_cast<std::int64_t>(lacking.size() - drawn))));
  }
  announce("all films are drawn: the session can begin");
}

}  // namespace bimodal::runner
