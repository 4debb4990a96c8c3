#include "analysis/data/stored_data.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/data/cautions.hpp"
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

SessionSummary summarise(const StoredSession& stored, std::size_t file) {
  const auto& session = stored.session;
  return {.file = file,
          .id = session.id,
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

bool wanted(const std::vector<std::string>& selected, const std::string& name) {
  return selected.empty() || std::ranges::find(selected, name) != selected.end();
}

/// Counts what is left out, each trial under the first reason that applies.
class Sieve {
 public:
  explicit Sieve(const Selection& selection) : selection_{selection} {}

  bool passes(const Trial& trial) {
    if (!selection_.include_practice && trial.phase == "practice") return left_out(practice_);
    if (!wanted(selection_.participants, trial.participant)) return left_out(participant_);
    if (!wanted(selection_.conditions, trial.condition)) return left_out(condition_);
    if (trial.excluded) return left_out(excluded_);
    if (selection_.exclude_flagged && trial.flagged) return left_out(flagged_);
    if (selection_.exclude_simulated && trial.simulated) return left_out(simulated_);
    return true;
  }

  [[nodiscard]] std::vector<Exclusion> exclusions() const {
    std::vector<Exclusion> all;
    if (!selection_.include_practice) all.push_back({"practice trial", practice_});
    if (!selection_.participants.empty()) {
      all.push_back({"participant not selected", participant_});
    }
    if (!selection_.conditions.empty()) all.push_back({"condition not selected", condition_});
    if (excluded_ > 0) {
      all.push_back({"excluded by the protocol's rule: timing not as planned", excluded_});
    }
    if (selection_.exclude_flagged) {
      all.push_back({"flagged: timing not as planned", flagged_});
    }
    if (selection_.exclude_simulated) all.push_back({"simulated answer", simulated_});
    return all;
  }

 private:
  static bool left_out(std::int64_t& count) {
    ++count;
    return false;
  }

  const Selection& selection_;
  std::int64_t practice_ = 0;
  std::int64_t excluded_ = 0;
  std::int64_t participant_ = 0;
  std::int64_t condition_ = 0;
  std::int64_t flagged_ = 0;
  std::int64_t simulated_ = 0;
};

void demand_known(const std::vector<std::string>& selected,
                  const std::set<std::string>& known,
                  std::string_view kind) {
  for (const auto& name : selected) {
    if (known.contains(name)) continue;
    throw Error{fmt::format("selecting trials: no {} \"{}\" in the data; there {} {}",
                            kind,
                            name,
                            known.size() == 1 ? "is only" : "are",
                            known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", ")))};
  }
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

Dataset gather_trials(std::span<const StoredFile> files, const Selection& selection) {
  refuse_doubled_sessions(files);
  Dataset dataset;
  Sieve sieve{selection};
  std::set<std::string> conditions;
  std::set<std::string> participants;
  for (const auto& [file, sessions, warnings] : files) {
    dataset.warnings.insert(dataset.warnings.end(), warnings.begin(), warnings.end());
    for (const auto& session : sessions) {
      auto summary = summarise(session, dataset.files.size());
      participants.insert(summary.participant);
      for (const auto& stored : session.trials) {
        conditions.insert(stored.plan.condition);
        ++dataset.stored_trials;
        auto trial = make_trial(stored, file, session);
        if (!sieve.passes(trial)) continue;
        trial.session = dataset.sessions.size();
        ++summary.analysed_trials;
        dataset.trials.push_back(std::move(trial));
      }
      dataset.sessions.push_back(std::move(summary));
    }
    dataset.files.push_back(file);
  }
  demand_known(selection.conditions, conditions, "condition");
  demand_known(selection.participants, participants, "participant");
  dataset.exclusions = sieve.exclusions();
  add_cautions(dataset);
  return dataset;
}

}  // namespace bimodal::analysis
