#include "analysis/report/benefits.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "analysis/report/results.hpp"

namespace bimodal::analysis {

namespace {

/// Who was heard and seen in a condition, over all of its trials.
struct Presentation {
  std::set<std::optional<std::string>> heard;
  std::set<std::optional<std::string>> seen;
  std::set<std::optional<double>> snr_db;
  std::set<std::optional<std::string>> looks;  ///< of synthetic faces
  bool is_dubbed = false;

  /// Something was heard in every trial.
  [[nodiscard]] bool has_voice() const { return !heard.contains(std::nullopt); }

  [[nodiscard]] bool has_face() const { return !seen.contains(std::nullopt); }

  [[nodiscard]] bool has_no_voice() const { return heard.size() == 1 && !has_voice(); }

  [[nodiscard]] bool has_no_face() const { return seen.size() == 1 && !has_face(); }
};

using Presentations = std::map<std::string, Presentation, std::less<>>;

Presentations presentations_of(const Results& results) {
  Presentations found;
  for (const auto& trial : results.dataset.trials) {
    auto& presentation = found[trial.condition];
    presentation.heard.insert(trial.auditory_talker);
    presentation.seen.insert(trial.visual_talker);
    presentation.snr_db.insert(trial.snr_db);
    presentation.looks.insert(trial.face);
    presentation.is_dubbed |= trial.visual_word && *trial.visual_word != trial.word;
  }
  return found;
}

/// The name of the only condition that is so; empty if there is none, or there are several.
template <typename Predicate>
std::string only_one(const Presentations& presentations, Predicate is_so) {
  std::string found;
  for (const auto& [name, presentation] : presentations) {
    if (!is_so(presentation)) continue;
    if (!found.empty()) return {};
    found = name;
  }
  return found;
}

/// Words of several conditions, whose participants and words have the same numbers.
class CrossedWords {
 public:
  CrossedWords(const Results& results, const std::vector<std::string>& conditions)
      : cells_(conditions.size()) {
    for (std::size_t i = 0; i < results.dataset.trials.size(); ++i) {
      const auto& trial = results.dataset.trials[i];
      const auto condition = std::ranges::find(conditions, trial.condition);
      if (condition == conditions.end()) continue;
      cells_[static_cast<std::size_t>(condition - conditions.begin())].push_back(
          {.participant = number_of(trial.participant, participants_),
           .word = number_of(trial.word, words_),
           .successes = results.scores[i].word_correct() ? 1U : 0U,
           .trials = 1});
    }
  }

  [[nodiscard]] const std::vector<CrossedCell>& cells(std::size_t condition) const {
    return cells_[condition];
  }

  [[nodiscard]] std::int64_t trials(std::size_t condition) const {
    return std::ssize(cells_[condition]);
  }

  [[nodiscard]] std::int64_t participants() const { return std::ssize(participants_); }

  [[nodiscard]] std::int64_t words() const { return std::ssize(words_); }

  [[nodiscard]] double proportion(std::size_t condition) const {
    double correct = 0.0;
    for (const auto& cell : cells_[condition]) correct += cell.successes;
    return correct / static_cast<double>(trials(condition));
  }

  /// Proportions of each condition in draws of the same participants and words. Empty if some draw
  /// meets no trial of some condition, as it happens where there are few.
  [[nodiscard]] std::vector<std::vector<double>> replicates(
      CrossedBootstrap::Options options) const {
    if (options.draws <= 0) return {};
    const CrossedBootstrap bootstrap{participants_.size(), words_.size(), options};
    std::vector<std::vector<double>> drawn;
    for (const auto& cells : cells_) {
      drawn.push_back(bootstrap.replicates(cells));
      if (std::ssize(drawn.back()) != options.draws) return {};
    }
    return drawn;
  }

  [[nodiscard]] std::string method(int draws) const {
    return fmt::format("crossed bootstrap, {} participants x {} words, {} draws",
                       participants_.size(),
                       words_.size(),
                       draws);
  }

 private:
  using Numbers = std::unordered_map<std::string, std::uint32_t>;

  static std::uint32_t number_of(const std::string& name, Numbers& numbers) {
    return numbers.try_emplace(name, static_cast<std::uint32_t>(numbers.size())).first->second;
  }

  Numbers participants_;
  Numbers words_;
  std::vector<std::vector<CrossedCell>> cells_;  ///< of each condition
};

/// The conditions of a row, as CrossedWords numbers them.
constexpr std::size_t kAuditory = 0;
constexpr std::size_t kBimodal = 1;
constexpr std::size_t kVisual = 2;
constexpr std::size_t kSynthetic = 2;  ///< where kBimodal is the natural face

/// The interval of a figure that is made from the conditions' proportions in one draw; absent
/// where more than 1 % of the draws do not define it, or it is always the same.
template <typename Figure>
std::optional<Interval> interval_of(const std::vector<std::vector<double>>& drawn, Figure figure) {
  std::vector<double> figures;
  const auto draws = drawn.front().size();
  for (std::size_t i = 0; i < draws; ++i) {
    if (const std::optional<double> value = figure(i)) figures.push_back(*value);
  }
  if (figures.empty() || 100 * (draws - figures.size()) > draws) return std::nullopt;
  const auto [least, most] = std::ranges::minmax(figures);
  if (least == most) return std::nullopt;
  return percentile_interval(std::move(figures));
}

constexpr std::string_view kOneParticipant =
    "no interval: one participant tells nothing about others";
constexpr std::string_view kTooFew = "no interval: too few trials, or too few correct, to resample";

void estimate(const CrossedWords& words, CrossedBootstrap::Options options, BenefitRow& row) {
  if (row.participants < 2) {
    row.method = kOneParticipant;
    return;
  }
  const auto drawn = words.replicates(options);
  row.method = kTooFew;
  if (drawn.empty()) return;
  const auto in_draw = [&](std::size_t i) {
    return benefit(drawn[kBimodal][i], drawn[kAuditory][i], std::nullopt);
  };
  row.gain_interval =
      interval_of(drawn, [&](std::size_t i) { return std::optional{in_draw(i).gain}; });
  row.relative_interval = interval_of(drawn, [&](std::size_t i) { return in_draw(i).relative; });
  if (row.gain_interval || row.relative_interval) row.method = words.method(options.draws);
}

std::vector<ParticipantBenefit> each_participant(const Results& results, const BenefitRow& row) {
  const auto proportion_of = [&](const std::string& participant, const std::string& condition) {
    const auto own = std::ranges::find_if(results.individual, [&](const Proportion& proportion) {
      return proportion.measure == Measure::Word && proportion.participant == participant &&
             proportion.condition == condition;
    });
    return own == results.individual.end() ? std::nullopt : own->proportion;
  };
  std::vector<ParticipantBenefit> found;
  for (const auto& participant : results.participants) {
    const auto auditory = proportion_of(participant, row.auditory);
    const auto bimodal = proportion_of(participant, row.bimodal);
    if (auditory && bimodal) found.push_back({participant, *auditory, *bimodal});
  }
  return found;
}

BenefitRow tabulate_benefit(const Results& results, BenefitRow row) {
  std::vector<std::string> conditions{row.auditory, row.bimodal};
  if (!row.visual.empty()) conditions.push_back(row.visual);
  const CrossedWords words{results, conditions};
  row.participants = words.participants();
  row.words = words.words();
  row.n = words.trials(kBimodal);
  row.n_auditory = words.trials(kAuditory);
  row.a = words.proportion(kAuditory);
  row.av = words.proportion(kBimodal);
  if (!row.visual.empty()) {
    row.n_visual = words.trials(kVisual);
    row.v = words.proportion(kVisual);
  }
  row.benefit = benefit(row.av, row.a, row.v);
  estimate(words, results.bootstrap, row);
  row.own = each_participant(results, row);
  return row;
}

ShareRow tabulate_share(const Results& results, ShareRow row) {
  const CrossedWords words{results, {row.auditory, row.natural, row.synthetic}};
  row.participants = words.participants();
  row.words = words.words();
  row.share = share_of_natural_benefit(
      words.proportion(kSynthetic), words.proportion(kBimodal), words.proportion(kAuditory));
  if (!row.share) {
    row.method = "none: the natural face adds nothing";
    return row;
  }
  if (row.participants < 2) {
    row.method = kOneParticipant;
    return row;
  }
  const auto drawn = words.replicates(results.bootstrap);
  row.method = kTooFew;
  if (drawn.empty()) return row;
  row.interval = interval_of(drawn, [&](std::size_t i) {
    return share_of_natural_benefit(drawn[kSynthetic][i], drawn[kBimodal][i], drawn[kAuditory][i]);
  });
  row.method = row.interval
                   ? words.method(results.bootstrap.draws)
                   : "no interval: in more than 1 % of the draws the natural face adds nothing";
  return row;
}

using Talkers = std::set<std::optional<std::string>>;

bool is_recorded(const std::optional<std::string>& talker) {
  return talker && talker->starts_with("corpus:");
}

/// Which conditions show a natural or a synthetic face.
class FaceKinds {
 public:
  explicit FaceKinds(const Results& results) : presentations_{presentations_of(results)} {
    if (!results.faces) return;
    natural_ = talkers_of(results.faces->natural);
    synthetic_ = talkers_of(results.faces->synthetic);
  }

  [[nodiscard]] bool is_natural(const std::string& condition) const {
    const auto seen = talkers_of(condition);
    return natural_.empty() ? std::ranges::all_of(seen, is_recorded) : seen == natural_;
  }

  [[nodiscard]] bool is_synthetic(const std::string& condition) const {
    const auto seen = talkers_of(condition);
    return synthetic_.empty() ? std::ranges::none_of(seen, is_recorded) : seen == synthetic_;
  }

 private:
  [[nodiscard]] Talkers talkers_of(const std::string& condition) const {
    const auto found = presentations_.find(condition);
    return found == presentations_.end() ? Talkers{} : found->second.seen;
  }

  Presentations presentations_;
  Talkers natural_;  ///< empty: nobody said
  Talkers synthetic_;
};

}  // namespace

std::vector<BenefitRow> tabulate_benefits(const Results& results) {
  const auto presentations = presentations_of(results);
  std::vector<BenefitRow> rows;
  for (const auto& condition : results.conditions) {
    const auto& both = presentations.at(condition.name);
    if (!both.has_voice() || !both.has_face() || both.is_dubbed) continue;
    BenefitRow row{.bimodal = condition.name};
    row.auditory = only_one(presentations, [&](const Presentation& one) {
      return one.has_no_face() && one.heard == both.heard && one.snr_db == both.snr_db;
    });
    if (row.auditory.empty()) continue;
    row.visual = only_one(presentations, [&](const Presentation& one) {
      return one.has_no_voice() && one.seen == both.seen && one.looks == both.looks;
    });
    rows.push_back(tabulate_benefit(results, std::move(row)));
  }
  return rows;
}

std::vector<ShareRow> tabulate_shares(const Results& results) {
  const FaceKinds kinds{results};
  std::vector<ShareRow> rows;
  for (const auto& natural : results.benefits) {
    if (!kinds.is_natural(natural.bimodal)) continue;
    for (const auto& synthetic : results.benefits) {
      if (!kinds.is_synthetic(synthetic.bimodal) || synthetic.auditory != natural.auditory)
        continue;
      if (synthetic.bimodal == natural.bimodal) continue;
      rows.push_back(tabulate_share(results,
                                    {.natural = natural.bimodal,
                                     .synthetic = synthetic.bimodal,
                                     .auditory = natural.auditory}));
    }
  }
  return rows;
}

}  // namespace bimodal::analysis
