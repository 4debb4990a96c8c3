#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "analysis/data/gathering.hpp"
#include "runner/store/stored_session.hpp"

namespace bimodal::analysis {

/// The sessions of one file.
struct StoredFile {
  SourceFile file;
  std::vector<runner::StoredSession> sessions;
  std::vector<std::string> warnings;  ///< about the file itself
};

/// Reads every file. Throws Error if one cannot be read or is given twice (by content), and
/// runner::StoreError if one is no readable store.
[[nodiscard]] std::vector<StoredFile> read_stored_files(
    std::span<const std::filesystem::path> files);

/// Turns stored sessions into trials. Throws Error for a session that occurs twice (the same
/// participant, start and seed, e.g. from a copy of a file) and for phones that are none.
[[nodiscard]] std::vector<TrialsOfFile> trials_of(std::span<const StoredFile> files);

/// The chosen trials of stored sessions: gather() of trials_of().
[[nodiscard]] Dataset gather_trials(std::span<const StoredFile> files,
                                    const Selection& selection = {});

}  // namespace bimodal::analysis
