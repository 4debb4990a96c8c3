#pragma once

#include <string>
#include <vector>

#include "runner/monitor/session_picture.hpp"
#include "runner/store/stored_session.hpp"

namespace bimodal::runner {

/// Columns and rows of a terminal.
struct ScreenSize {
  std::size_t columns = 80;
  std::size_t rows = 24;
};

/// The screen of a running session, row by row from the top: at most `size.rows` rows, none wider
/// than `size.columns`. `now` is on the session clock (CLOCK_MONOTONIC). `footer` stands in the
/// last row: what the keys do, or a question; empty: there is none. Pure.
[[nodiscard]] std::vector<std::string> monitor_screen(const SessionPicture& picture,
                                                      Instant now,
                                                      ScreenSize size,
                                                      const std::string& footer);

/// One line for the news of a kind, where there is no screen to be repainted; empty: no news.
[[nodiscard]] std::string news_line(const SessionPicture& picture, const std::string& kind);

/// How the session ended, in a sentence.
[[nodiscard]] std::string end_text(const SessionPicture& picture);

/// What a data file holds, for when nothing runs: each session, and its main trials by condition.
[[nodiscard]] std::vector<std::string> stored_screen(const std::vector<StoredSession>& sessions);

}  // namespace bimodal::runner
