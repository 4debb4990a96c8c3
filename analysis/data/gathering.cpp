#include "analysis/data/gathering.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/data/cautions.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/milliseconds.hpp"

namespace bimodal::analysis {

namespace {

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
    if (!response_time(trial)) ++without_time_;
    if (is_too_fast(trial)) return left_out(fast_);
    if (is_too_slow(trial)) return left_out(slow_);
    if (!trial.timing_known) ++without_timing_;
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
    if (selection_.fastest) {
      all.push_back(
          {fmt::format("answered in less than {:g} ms", milliseconds(*selection_.fastest)), fast_});
    }
    if (selection_.slowest) {
      all.push_back(
          {fmt::format("answered after more than {:g} ms", milliseconds(*selection_.slowest)),
           slow_});
    }
    if (selection_.exclude_flagged) {
      all.push_back({"flagged: timing not as planned", flagged_});
    }
    if (selection_.exclude_simulated) all.push_back({"simulated answer", simulated_});
    return all;
  }

  /// Of rules that could not judge every trial.
  void warn(std::vector<std::string>& warnings) const {
    if ((selection_.fastest || selection_.slowest) && without_time_ > 0) {
      warnings.push_back(fmt::format(
          "{} no response time, so that the limits of response times do not hold for {}.",
          without_time_ == 1 ? "1 trial has" : fmt::format("{} trials have", without_time_),
          without_time_ == 1 ? "it" : "them"));
    }
    if (selection_.exclude_flagged && without_timing_ > 0) {
      warnings.push_back(fmt::format(
          "Of {} it is not known whether the timing was as planned (the table does not say in a "
          "column flagged), so that leaving out flagged trials does not concern {}.",
          without_timing_ == 1 ? "1 trial" : fmt::format("{} trials", without_timing_),
          without_timing_ == 1 ? "it" : "them"));
    }
  }

 private:
  static bool left_out(std::int64_t& count) {
    ++count;
    return false;
  }

  static std::optional<Duration> response_time(const Trial& trial) {
    return trial.first_key ? trial.first_key : trial.submitted;
  }

  [[nodiscard]] bool is_too_fast(const Trial& trial) const {
    const auto time = response_time(trial);
    return selection_.fastest && time && *time < *selection_.fastest;
  }

  [[nodiscard]] bool is_too_slow(const Trial& trial) const {
    const auto time = response_time(trial);
    return selection_.slowest && time && *time > *selection_.slowest;
  }

  const Selection& selection_;
  std::int64_t practice_ = 0;
  std::int64_t excluded_ = 0;
  std::int64_t participant_ = 0;
  std::int64_t condition_ = 0;
  std::int64_t without_time_ = 0;
  std::int64_t without_timing_ = 0;
  std::int64_t fast_ = 0;
  std::int64_t slow_ = 0;
  std::int64_t flagged_ = 0;
  std::int64_t simulated_ = 0;
};

std::size_t count_trials(const std::vector<TrialsOfFile>& files) {
  std::size_t count = 0;
  for (const auto& file : files) {
    for (const auto& session : file.sessions) count += session.trials.size();
  }
  return count;
}

void demand_known(const std::vector<std::string>& selected,
                  const std::set<std::string>& known,
                  std::string_view kind) {
  for (const auto& name : selected) {
    if (known.contains(name)) continue;
    throw Error{fmt::format(
        "selecting trials: no {} \"{}\" in the data; {}", kind, name, names_there(known))};
  }
}

}  // namespace

std::string names_there(const std::set<std::string>& names) {
  if (names.empty()) return "there are none";
  return fmt::format("there {} {}", names.size() == 1 ? "is only" : "are", fmt::join(names, ", "));
}

Dataset gather(std::vector<TrialsOfFile>&& files, const Selection& selection) {
  Dataset dataset;
  dataset.trials.reserve(count_trials(files));
  Sieve sieve{selection};
  std::set<std::string> conditions;
  std::set<std::string> participants;
  for (auto& read : files) {
    std::ranges::move(read.warnings, std::back_inserter(dataset.warnings));
    for (auto& [summary, trials] : read.sessions) {
      summary.file = dataset.files.size();
      participants.insert(summary.participant);
      for (auto& trial : trials) {
        conditions.insert(trial.condition);
        ++dataset.stored_trials;
        if (!sieve.passes(trial)) continue;
        trial.session = dataset.sessions.size();
        ++summary.analysed_trials;
        dataset.trials.push_back(std::move(trial));
      }
      std::vector<Trial>{}.swap(trials);  // a million of them take half a gigabyte
      dataset.sessions.push_back(std::move(summary));
    }
    dataset.files.push_back(std::move(read.file));
  }
  demand_known(selection.conditions, conditions, "condition");
  demand_known(selection.participants, participants, "participant");
  dataset.exclusions = sieve.exclusions();
  sieve.warn(dataset.warnings);
  add_cautions(dataset);
  return dataset;
}

}  // namespace bimodal::analysis
