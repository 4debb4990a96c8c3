#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "analysis/data/dataset.hpp"
#include "runner/store/stored_session.hpp"

namespace bimodal::analysis {

/// The sessions of one file.
struct StoredFile {
  SourceFile file;
  std::vector<runner::StoredSession> sessions;
  std::vector<std::string> warnings;  ///< about the file itself
};

/// Which trials are wanted.
struct Selection {
  bool include_practice = false;
  bool exclude_flagged = false;
  bool exclude_simulated = false;
  std::vector<std::string> conditions;    ///< by name; empty: all
  std::vector<std::string> participants;  ///< by name; empty: all
};

/// Reads every file. Throws Error if one cannot be read or is given twice (by content), and
/// runner::StoreError if one is no readable store.
[[nodiscard]] std::vector<StoredFile> read_stored_files(
    std::span<const std::filesystem::path> files);

/// Turns stored sessions into trials. Throws Error for a session that occurs twice (the same
/// participant, start and seed, e.g. from a copy of a file), for phones that are none, and for a
/// selected condition or participant that does not occur.
[[nodiscard]] Dataset gather_trials(std::span<const StoredFile> files,
                                    const Selection& selection = {});

}  // namespace bimodal::analysis
