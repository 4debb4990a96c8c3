#include "analysis/report/face_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/report/confusions.hpp"
#include "analysis/report/results.hpp"
#include "analysis/scoring/label_pair.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::analysis {

namespace {

/// All that two matrices tell.
FaceComparison describe_matrices(const ConfusionMatrix& one,
                                 const ConfusionMatrix& other,
                                 const Resampling& resampling) {
  FaceComparison found;
  std::tie(found.one_matrix, found.other_matrix) = with_common_labels(one, other);
  found.cells = compare_matrices(found.one_matrix, found.other_matrix);
  const auto test = [&](DissimilarityMeasure measure) {
    return mantel(dissimilarities(found.one_matrix, measure),
                  dissimilarities(found.other_matrix, measure),
                  resampling.permutations,
                  resampling.seed);
  };
  found.mantel_phi = test(DissimilarityMeasure::Phi);
  found.mantel_confusion = test(DissimilarityMeasure::Confusion);
  found.contrasts = rank_contrasts(found.one_matrix, found.other_matrix);
  return found;
}

/// Every response as a trial of its own that may be exchanged with any other to the same stimulus.
std::vector<ComparedTrial> as_responses(const ConfusionMatrix& one, const ConfusionMatrix& other) {
  std::vector<ComparedTrial> trials;
  const auto columns = one.responses().size();
  for (std::uint32_t i = 0; i < one.stimuli().size(); ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      for (const bool is_other : {false, true}) {
        const auto count = std::llround((is_other ? other : one).count(i, j));
        const ComparedTrial trial{.participant = i,
                                  .item = i,
                                  .other = is_other,
                                  .correct = one.stimuli()[i] == one.responses()[j],
                                  .cells = {static_cast<std::uint32_t>(i * columns + j)}};
        trials.insert(trials.end(), static_cast<std::size_t>(count), trial);
      }
    }
  }
  return trials;
}

/// Numbers names in the order in which they are met.
class Numbering {
 public:
  std::uint32_t of(const std::string& name) {
    return numbers_.try_emplace(name, static_cast<std::uint32_t>(numbers_.size())).first->second;
  }

  [[nodiscard]] std::size_t size() const { return numbers_.size(); }

 private:
  std::unordered_map<std::string, std::uint32_t> numbers_;
};

/// The trials of both conditions, by participant and word.
struct ComparedTrials {
  std::vector<ComparedTrial> trials;
  std::vector<ParticipantConfusions> participants;
  std::vector<CrossedCell> words_one;
  std::vector<CrossedCell> words_other;
  std::size_t words = 0;
};

/// Where labels are in a matrix.
std::unordered_map<std::string, std::uint32_t> places_of(const std::vector<std::string>& labels) {
  std::unordered_map<std::string, std::uint32_t> places;
  for (std::uint32_t i = 0; i < labels.size(); ++i) places.emplace(labels[i], i);
  return places;
}

ComparedTrials collect(const Results& results, Unit unit, const FaceComparison& comparison) {
  ComparedTrials collected;
  const auto& labels = comparison.one_matrix;
  const auto rows = places_of(labels.stimuli());
  const auto columns = places_of(labels.responses());
  const ConfusionMatrix empty{labels.stimuli(), labels.responses()};
  Numbering participants;
  Numbering items;
  for (std::size_t i = 0; i < results.dataset.trials.size(); ++i) {
    const auto& trial = results.dataset.trials[i];
    const bool other = trial.condition == comparison.other;
    if (!other && trial.condition != comparison.one) continue;
    const auto& score = results.scores[i];
    ComparedTrial compared{.participant = participants.of(trial.participant),
                           .item = items.of(trial.word + '\n' + spell(trial.phones)),
                           .other = other,
                           .correct = score.word_correct(),
                           .cells = {}};
    if (compared.participant == collected.participants.size()) {
      collected.participants.push_back({empty, empty});
    }
    auto& own = collected.participants[compared.participant];
    for (const auto& pair : confusions_of(trial, score, unit)) {
      (other ? own.other : own.one).add(pair.stimulus, pair.response, pair.weight);
      // parts of responses cannot be exchanged whole: they go with the matrices, not with the test
      if (pair.weight < 1.0) continue;
      compared.cells.push_back(static_cast<std::uint32_t>(
          rows.at(pair.stimulus) * labels.responses().size() + columns.at(pair.response)));
    }
    (other ? collected.words_other : collected.words_one)
        .push_back({.participant = compared.participant,
                    .word = compared.item,
                    .successes = compared.correct ? 1U : 0U,
                    .trials = 1});
    collected.trials.push_back(std::move(compared));
  }
  collected.words = items.size();
  return collected;
}

double share_correct(const std::vector<CrossedCell>& cells) {
  double correct = 0.0;
  for (const auto& cell : cells) correct += cell.successes;
  return cells.empty() ? 0.0 : correct / static_cast<double>(cells.size());
}

/// Participants and words drawn again, the same ones for both conditions.
void estimate_ratio(const ComparedTrials& collected,
                    const Resampling& resampling,
                    FaceComparison& found) {
  const double one = share_correct(collected.words_one);
  const double other = share_correct(collected.words_other);
  if (one <= 0.0) {
    found.ratio_method = "none: no word was correct with the first condition";
    return;
  }
  found.ratio = other / one;
  if (collected.participants.size() < 2) {
    found.ratio_method = "no interval: one participant tells nothing about others";
    return;
  }
  constexpr std::int64_t kMostDraws = 10'000;
  const auto draws = static_cast<int>(std::min(resampling.permutations, kMostDraws));
  const CrossedBootstrap bootstrap{
      collected.participants.size(), collected.words, {.draws = draws, .seed = resampling.seed}};
  const auto ones = bootstrap.replicates_by_draw(collected.words_one);
  const auto others = bootstrap.replicates_by_draw(collected.words_other);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < ones.size(); ++i) {
    if (ones[i].value_or(0.0) > 0.0 && others[i]) ratios.push_back(*others[i] / *ones[i]);
  }
  if (100 * (draws - std::ssize(ratios)) > draws || ratios.empty()) {
    found.ratio_method =
        "no interval: in more than 1 % of the draws a condition has no correct word";
    return;
  }
  found.ratio_interval = percentile_interval(std::move(ratios));
  found.ratio_method = fmt::format("crossed bootstrap, {} participants x {} words, {} draws",
                                   collected.participants.size(),
                                   collected.words,
                                   draws);
}

void require_condition(const Results& results, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& condition : results.conditions) names.push_back(condition.name);
  if (std::ranges::find(names, name) != names.end()) return;
  throw Error{fmt::format("comparing conditions: the data have no condition \"{}\"; there are: {}",
                          name,
                          fmt::join(names, ", "))};
}

void require_conditions(const Results& results, const std::string& one, const std::string& other) {
  require_condition(results, one);
  require_condition(results, other);
  if (one != other) return;
  throw Error{fmt::format(
      "comparing conditions: both are \"{}\"; name two different ones, the natural face's first",
      one)};
}

constexpr std::size_t kFewestForHalves = 4;

}  // namespace

FaceComparison compare_faces(const ConfusionMatrix& one,
                             const ConfusionMatrix& other,
                             const Resampling& resampling) {
  auto found = describe_matrices(one, other, resampling);
  const auto ceiling = [&](bool off_diagonal) {
    return noise_ceiling(
        found.one_matrix, found.other_matrix, off_diagonal, resampling.splits, resampling.seed);
  };
  found.ceiling_all = ceiling(false);
  found.ceiling_off_diagonal = ceiling(true);
  found.exchanged_responses = true;
  found.permutation = permute_conditions(as_responses(found.one_matrix, found.other_matrix),
                                         found.one_matrix.stimuli().size(),
                                         found.one_matrix.responses().size(),
                                         resampling.permutations,
                                         resampling.seed);
  return found;
}

FaceComparison compare_faces(const Results& results,
                             Unit unit,
                             const std::string& one,
                             const std::string& other,
                             const Resampling& resampling) {
  require_conditions(results, one, other);
  const std::vector<std::string> both{one, other};
  const auto tables = tabulate_unit(results.dataset.trials, results.scores, both, unit);
  for (const auto& table : tables) {
    if (table.matrix.total() > 0.0) continue;
    throw Error{fmt::format(
        "comparing conditions: \"{}\" has no response for {}", table.condition, name(unit))};
  }
  auto found = describe_matrices(tables[0].matrix, tables[1].matrix, resampling);
  found.title = title(unit);
  found.unit = unit;
  found.one = one;
  found.other = other;
  const auto collected = collect(results, unit, found);
  found.participants = static_cast<std::int64_t>(collected.participants.size());
  const auto ceiling = [&](bool off_diagonal) {
    return collected.participants.size() >= kFewestForHalves
               ? noise_ceiling(
                     collected.participants, off_diagonal, resampling.splits, resampling.seed)
               : noise_ceiling(found.one_matrix,
                               found.other_matrix,
                               off_diagonal,
                               resampling.splits,
                               resampling.seed);
  };
  found.ceiling_all = ceiling(false);
  found.ceiling_off_diagonal = ceiling(true);
  found.permutation = permute_conditions(collected.trials,
                                         found.one_matrix.stimuli().size(),
                                         found.one_matrix.responses().size(),
                                         resampling.permutations,
                                         resampling.seed);
  estimate_ratio(collected, resampling, found);
  return found;
}

std::vector<FaceComparison> compare_faces(const Results& results,
                                          const std::string& one,
                                          const std::string& other,
                                          const Resampling& resampling) {
  require_conditions(results, one, other);
  const auto has_responses = [&](Unit unit, const std::string& condition) {
    return std::ranges::any_of(results.confusions, [&](const UnitConfusions& table) {
      return table.unit == unit && table.condition == condition && table.matrix.total() > 0.0;
    });
  };
  std::vector<FaceComparison> comparisons;
  for (const Unit unit : kPlaceUnits) {
    if (!has_responses(unit, one) || !has_responses(unit, other)) continue;
    comparisons.push_back(compare_faces(results, unit, one, other, resampling));
  }
  return comparisons;
}

std::vector<DifferentCell> significant_cells(const FaceComparison& comparison) {
  std::vector<DifferentCell> cells;
  const auto columns = comparison.one_matrix.responses().size();
  const auto& permutation = comparison.permutation;
  for (std::size_t cell = 0; cell < permutation.cell_q.size(); ++cell) {
    const auto& q = permutation.cell_q[cell];
    if (!q || *q > kFalseDiscoveryRate) continue;
    cells.push_back({cell / columns, cell % columns, permutation.difference[cell], *q});
  }
  std::ranges::stable_sort(cells, std::ranges::greater{}, [](const DifferentCell& cell) {
    return std::abs(cell.difference);
  });
  return cells;
}

}  // namespace bimodal::analysis
