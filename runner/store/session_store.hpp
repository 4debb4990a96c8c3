#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

#include "runner/store/records.hpp"

namespace bimodal::runner {

/// Where sessions are kept while they run. Every call but settle() is one committed transaction:
/// when it returns, the data are on the disk. Calls follow each other, from whatever thread; only
/// settle() may meet another, and then one of the two waits. All throw StoreError.
class SessionStore {
 public:
  SessionStore() = default;
  SessionStore(const SessionStore&) = delete;
  SessionStore& operator=(const SessionStore&) = delete;
  SessionStore(SessionStore&&) = delete;
  SessionStore& operator=(SessionStore&&) = delete;
  virtual ~SessionStore() = default;

  /// Stores the session and its whole plan; returns the session's number in this file.
  virtual std::int64_t begin(const SessionRecord& session, std::span<const PlanRecord> plan) = 0;

  virtual void add(std::int64_t session, const TrialRecord& trial) = 0;

  /// A trial that was not planned before the session: it repeats one of the plan.
  virtual void add(std::int64_t session, const PlanRecord& planned) = 0;

  /// An event outside any trial.
  virtual void add(std::int64_t session, const EventRecord& event) = 0;

  /// Takes up a session that was stopped or interrupted: it has no outcome again. What it has
  /// stays.
  virtual void reopen(std::int64_t session) = 0;

  /// `outcome`: "complete" or "stopped". A session that never ended was interrupted.
  virtual void end(std::int64_t session, std::string_view outcome, std::string_view ended_utc) = 0;

  /// Does what a transaction leaves for later, if it is due. Between transactions, when nobody
  /// waits: it may write much. Should it fail, nothing stored is lost.
  virtual void settle() = 0;
};

/// Opens or makes a SQLite file (mode 0600; WAL, synchronous=FULL, foreign keys). An existing file
/// is appended to. Its settle() moves what was committed from the log beside the file into the
/// file, some trials at a time. Throws StoreError if it is of a newer schema, no bimodal file, or
/// not writable.
[[nodiscard]] std::unique_ptr<SessionStore> open_sqlite_store(const std::filesystem::path& file);

/// Throws StoreError if a new `file` could not be made in its folder; makes nothing.
void require_place_for(const std::filesystem::path& file);

}  // namespace bimodal::runner
