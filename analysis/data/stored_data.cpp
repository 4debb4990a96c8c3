#include "analysis/data/stored_data.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::analysis {

namespace {

using runner::StoredSession;
using runner::StoredTrial;

Pronunciation phones_of(const StoredTrial& stored,
                        const SourceFile& file,
                        const StoredSession& session) {
  Pronunciation phones;
  std::istringstream symbols{stored.plan.phones};
  for (std::string symbol; symbols >> symbol;) {
    const auto phone = phone_from_symbol(symbol);
    if (!phone || *phone == Phone::Rest) {
      throw Error{fmt::format(
          "reading '{}', session {}, trial {}: \"{}\" in the phones \"{}\" of \"{}\" is "
          "no phone; the file was not written by this program or has been changed",
          file.name,
          session.session.id,
          stored.plan.trial,
          symbol,
          stored.plan.phones,
          stored.plan.word)};
    }
    phones.push_back(*phone);
  }
  return phones;
}

bool is_simulated(const StoredSession& session) {
  return session.session.simulated_answers || session.session.simulated_time;
}

SessionSummary summarise(const StoredSession& stored) {
  const auto& session = stored.session;
  return {.id = session.id,
          .participant = session.participant,
          .participant_number = session.participant_number,
          .session_number = session.session_number,
          .protocol_title = session.protocol_title,
          .protocol_sha256 = session.protocol_sha256,
          .seed = session.seed,
          .program_version = session.program_version,
          .started_utc = session.started_utc,
          .outcome = stored.outcome.empty() ? "interrupted" : stored.outcome,
          .observer = session.observer,
          .simulated = is_simulated(stored),
          .planned_trials = stored.planned_trials,
          .face_quality = session.face ? session.face->quality : std::string{},
          .face_quality_basis = session.face ? session.face->basis : std::string{},
          .shortened = stored.shortened,
          .stored_trials = static_cast<int>(stored.trials.size()),
          .analysed_trials = 0,
          .flagged_trials = static_cast<int>(std::ranges::count_if(
              stored.trials, [](const StoredTrial& trial) { return trial.trial.flagged; }))};
}

/// From where reaction times count: as the protocol names it, in old files the planned end.
Duration reference_of(const runner::TrialRecord& trial) {
  return trial.response.reference_at.value_or(trial.stimulus_end);
}

Trial make_trial(const StoredTrial& stored, const SourceFile& file, const StoredSession& session) {
  const auto& [plan, trial] = stored;
  Trial made{.session = 0,
             .participant = session.session.participant,
             .trial = plan.trial,
             .phase = plan.phase,
             .block = plan.block,
             .condition = plan.condition,
             .auditory_talker = plan.auditory_talker,
             .visual_talker = plan.visual_talker,
             .snr_db = plan.snr_db,
             .word = plan.word,
             .visual_word = plan.visual_word,
             .articulation = plan.articulation,
             .face = plan.face,
             .phones = phones_of(stored, file, session),
             .response = trial.response.text,
             .first_key = std::nullopt,
             .submitted = trial.response.submitted - reference_of(trial),
             .timed_out = trial.response.timed_out,
             .flagged = trial.flagged,
             .excluded = trial.excluded,
             .simulated = is_simulated(session)};
  if (trial.response.first_key) made.first_key = *trial.response.first_key - reference_of(trial);
  return made;
}

void refuse_doubled_sessions(std::span<const StoredFile> files) {
  std::map<std::tuple<std::string, std::string, std::string, std::uint64_t, int>, std::string> seen;
  for (const auto& file : files) {
    for (const auto& stored : file.sessions) {
      const auto& session = stored.session;
      const auto [found, is_new] = seen.try_emplace({session.participant,
                                                     session.started_utc,
                                                     session.protocol_sha256,
                                                     session.seed,
                                                     session.session_number},
                                                    file.file.name);
      if (is_new || session.started_utc.empty() || found->second == file.file.name) continue;
      throw Error{
          fmt::format("reading '{}': its session {} (participant {}, started {}) is also in "
                      "'{}'; give each session once",
                      file.file.name,
                      session.id,
                      session.participant,
                      session.started_utc,
                      found->second)};
    }
  }
}

}  // namespace

std::vector<StoredFile> read_stored_files(std::span<const std::filesystem::path> files) {
  std::vector<StoredFile> read;
  for (const auto& path : files) {
    StoredFile stored;
    stored.file = {path.string(), sha256_of_file(path)};
    const auto same = std::ranges::find(
        read, stored.file.sha256, [](const StoredFile& other) { return other.file.sha256; });
    if (same != read.end()) {
      throw Error{fmt::format("reading '{}': it has the same content as '{}'; give each file once",
                              stored.file.name,
                              same->file.name)};
    }
    auto log = path;
    log += "-wal";
    std::error_code ignored;
    if (std::filesystem::file_size(log, ignored) > 0 && !ignored) {
      stored.warnings.push_back(
          fmt::format("'{}' is still being written, or was left by an interrupted session: its "
                      "newest trials are in '{}', which the SHA-256 given here does not cover.",
                      stored.file.name,
                      log.string()));
    }
    stored.sessions = runner::read_sessions(path);
    read.push_back(std::move(stored));
  }
  return read;
}

std::vector<TrialsOfFile> trials_of(std::span<const StoredFile> files) {
  refuse_doubled_sessions(files);
  std::vector<TrialsOfFile> all;
  for (const auto& [file, sessions, warnings] : files) {
    TrialsOfFile read{.file = file, .sessions = {}, .warnings = warnings};
    for (const auto& session : sessions) {
      SessionTrials made{.summary = summarise(session), .trials = {}};
      for (const auto& stored : session.trials) {
        made.trials.push_back(make_trial(stored, file, session));
      }
      read.sessions.push_back(std::move(made));
    }
    all.push_back(std::move(read));
  }
  return all;
}

Dataset gather_trials(std::span<const StoredFile> files, const Selection& selection) {
  return gather(trials_of(files), selection);
}

}  // namespace bimodal::analysis
