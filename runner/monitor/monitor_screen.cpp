#include "runner/monitor/monitor_screen.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "runner/monitor/screen_text.hpp"

namespace bimodal::runner {

namespace {

constexpr std::size_t kTableWidth = 40;
constexpr double kNanosecondsPerMillisecond = 1e6;

std::size_t count(const SessionPicture& picture, std::string_view kind, std::string_view key) {
  return static_cast<std::size_t>(std::max<std::int64_t>(picture.number(kind, key).value_or(0), 0));
}

/// Trials of the whole session, also of the part before it was cut off.
std::size_t stored_trials(const SessionPicture& picture) {
  return picture.knows("tally") ? count(picture, "tally", "stored")
                                : count(picture, "session", "stored_before");
}

/// The later of the two tells where the participant is.
bool is_on_page(const SessionPicture& picture) {
  return picture.number("page", "at_ns").value_or(-1) >
         picture.number("trial", "at_ns").value_or(-1);
}

std::string place(const SessionPicture& picture) {
  if (is_on_page(picture)) {
    return fmt::format("{}: \"{}\"",
                       picture.flag("page", "is_break") ? "break" : "a page is read",
                       picture.text("page", "text"));
  }
  if (!picture.knows("trial")) return "the session is about to begin";
  return fmt::format("trial {} of {}   block {} of {}   {}   {}   \"{}\"",
                     count(picture, "trial", "trial") + 1,
                     count(picture, "trial", "of"),
                     count(picture, "trial", "block") + 1,
                     count(picture, "session", "blocks"),
                     picture.text("trial", "phase"),
                     picture.text("trial", "condition"),
                     picture.text("trial", "word"));
}

std::string state(const SessionPicture& picture) {
  const auto pause = picture.text("pause", "state");
  if (pause == "paused") return "PAUSED";
  const auto now = is_on_page(picture) ? std::string{"waits"} : picture.text("trial", "state");
  return pause == "asked" ? now + ", pause asked" : now;
}

std::string times(const SessionPicture& picture, Instant now, std::size_t width) {
  const auto stored = stored_trials(picture);
  const auto of = count(picture, "session", "trials");
  std::string told;
  if (const auto at = picture.number("times", "at_ns")) {
    const auto since = now.time_since_epoch().count() - *at;
    const auto elapsed = picture.number("times", "elapsed_ns").value_or(0) + since;
    told += "  elapsed " + clock_text(Duration{elapsed});
  }
  if (const auto left = picture.number("times", "left_ns")) {
    told += "  " + rough_text(Duration{*left}) + " left";
  } else {
    told += "  time left: after 3 trials";
  }
  return bar(stored, of, width > told.size() ? width - told.size() : 0) + told;
}

std::string flags(const SessionPicture& picture) {
  const auto before = count(picture, "session", "stored_before");
  auto told = fmt::format("stored {}{}   flagged {}",
                          stored_trials(picture),
                          before > 0 ? fmt::format(" ({} before)", before) : std::string{},
                          count(picture, "tally", "flagged"));
  const auto events = picture.last_events();
  if (!events.empty()) {
    told += fmt::format("   trial {}: {}", count(picture, "result", "trial") + 1, events);
  }
  return told;
}

std::string refresh(const SessionPicture& picture) {
  if (!picture.knows("health")) return "refresh and sound: told after the first trial";
  const auto milliseconds = [&](std::string_view key) {
    return picture.real("health", key).value_or(0.0) / kNanosecondsPerMillisecond;
  };
  auto told = fmt::format("refresh {:.3f} ms", milliseconds("refresh_period_ns"));
  if (count(picture, "health", "refreshes_measured") > 0) {
    told += fmt::format(", SD {:.3f} ms", milliseconds("refresh_deviation_ns"));
  } else {
    told += " (not measured)";
  }
  return told + fmt::format("   missed {}   late frames {}",
                            count(picture, "health", "missed_refreshes"),
                            count(picture, "health", "late_frames"));
}

std::string sound(const SessionPicture& picture) {
  if (!picture.knows("health")) return {};
  auto told = fmt::format("sound: {}underflows {}",
                          picture.flag("health", "sound_lost") ? "THE DEVICE IS LOST   " : "",
                          count(picture, "health", "underflows"));
  if (const auto drift = picture.real("health", "sound_drift_ppm")) {
    told += fmt::format("   drift {:+.1f} ppm", *drift);
  }
  if (const auto storing = picture.real("health", "longest_storing_ns"); storing > 0.0) {
    told +=
        fmt::format("   answers stored within {:.1f} ms", *storing / kNanosecondsPerMillisecond);
  }
  return told;
}

std::string who(const SessionPicture& picture) {
  return fmt::format("{}   session {}{}",
                     picture.text("session", "participant"),
                     count(picture, "session", "session_number"),
                     picture.flag("session", "simulated_answers") ? "   simulated answers" : "");
}

std::string display(const SessionPicture& picture) {
  const auto verdict = picture.text("session", "verdict");
  return (verdict.empty() ? "" : "timing: " + verdict + "   ") + picture.text("session", "display");
}

/// "  12! AV_syn   stew -> shoe"; '=': as spelled.
std::string trial_row(const TalliedTrial& trial) {
  return fmt::format("{:4}{} {} {} {} {}",
                     trial.trial + 1,
                     trial.flagged ? "!" : " ",
                     fitted(trial.condition, 8),
                     trial.word,
                     trial.spelled_as_target.value_or(false) ? "=" : "->",
                     trial.response.empty() ? "(none)" : trial.response);
}

std::vector<std::string> latest_table(const SessionPicture& picture) {
  std::vector<std::string> table{"latest answers (! flagged)"};
  auto trials = picture.latest_trials();
  std::ranges::reverse(trials);
  for (const auto& trial : trials) table.push_back(trial_row(trial));
  return table;
}

std::string rule(std::size_t width) {
  return std::string(width, '-');
}

}  // namespace

std::vector<std::string> monitor_screen(const SessionPicture& picture,
                                        Instant now,
                                        ScreenSize size,
                                        const std::string& footer) {
  const auto width = size.columns;
  std::vector<std::string> rows{apart(picture.text("session", "title"), "  " + who(picture), width),
                                display(picture),
                                picture.text("session", "audio"),
                                rule(width),
                                apart(place(picture), "   " + state(picture), width),
                                times(picture, now, width),
                                flags(picture),
                                refresh(picture),
                                sound(picture)};
  const auto reason = picture.text("pause", "reason");
  rows.push_back(reason.empty() ? rule(width) : "pause: " + reason);
  const std::size_t below = footer.empty() ? 0 : 2;
  const auto room = size.rows > rows.size() + below ? size.rows - rows.size() - below : 0;
  const auto conditions = condition_table(picture.conditions(), room);
  const auto latest = latest_table(picture);
  for (std::size_t i = 0; i < std::min(room, std::max(conditions.size(), latest.size())); ++i) {
    rows.push_back(fitted(i < conditions.size() ? conditions[i] : "", kTableWidth) +
                   (i < latest.size() ? latest[i] : ""));
  }
  if (!footer.empty()) {
    rows.push_back(rule(width));
    rows.push_back(footer);
  }
  if (rows.size() > size.rows) rows.resize(size.rows);
  for (auto& row : rows) row = fitted(harmless(row), width);
  return rows;
}

std::string news_line(const SessionPicture& picture, const std::string& kind) {
  std::string news;
  if (kind == "session") news = picture.text("session", "title") + "   " + who(picture);
  if (kind == "page") news = place(picture);
  if (kind == "trial" && picture.text("trial", "state") == "fixation") news = place(picture);
  if (kind == "result") {
    const auto response = picture.text("result", "response");
    news = "answer: " + (response.empty() ? "(none)" : response);
    if (picture.flag("result", "flagged")) news += "   ! " + picture.last_events();
  }
  if (kind == "pause") {
    const auto reason = picture.text("pause", "reason");
    news = picture.text("pause", "state") + (reason.empty() ? "" : ": " + reason);
  }
  if (kind == "error") news = "refused: " + picture.text("error", "text");
  return harmless(news);
}

std::string end_text(const SessionPicture& picture) {
  if (!picture.knows("ended")) {
    return "the session's program has gone without a word; every answered trial is stored";
  }
  auto told = fmt::format("{}: {} of {} trials stored in {}, {} flagged",
                          picture.text("ended", "outcome"),
                          count(picture, "ended", "stored"),
                          count(picture, "ended", "of"),
                          picture.text("session", "data"),
                          count(picture, "ended", "flagged"));
  const auto detail = picture.text("ended", "detail");
  return harmless(detail.empty() ? told : told + "; " + detail);
}

}  // namespace bimodal::runner
