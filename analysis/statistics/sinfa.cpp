#include "analysis/statistics/sinfa.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

namespace bimodal::analysis {

namespace {

/// Ratios that differ by less are the same, computed in another order.
constexpr double kTie = 1e-9;

/// One kind of response, and how often it was given.
struct Cell {
  std::size_t stimulus;
  std::size_t response;
  double count;
};

/// Sum of k log2 k: what entropies of counts are made of.
template <typename Key>
double sum_of_logs(const std::map<Key, double>& counts) {
  double sum = 0.0;
  for (const auto& [key, k] : counts) sum += k * std::log2(k);
  return sum;
}

bool applies(const Feature& feature, const Cell& cell) {
  return !feature.of_stimuli[cell.stimulus].empty() && !feature.of_responses[cell.response].empty();
}

bool agrees(const Feature& feature, const Cell& cell) {
  return feature.of_stimuli[cell.stimulus] == feature.of_responses[cell.response];
}

class Analysis {
 public:
  Analysis(const ConfusionMatrix& matrix, std::span<const Feature> features) : features_{features} {
    for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
      for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
        if (matrix.count(i, j) > 0) cells_.push_back({i, j, matrix.count(i, j)});
      }
    }
    std::erase_if(cells_, [&](const Cell& cell) {
      return !std::ranges::all_of(features_,
                                  [&](const Feature& feature) { return applies(feature, cell); });
    });
    result_.responses = responses();
    result_.left_out = matrix.total() - result_.responses;
    for (std::size_t i = 0; i < features_.size(); ++i) left_.push_back(i);
  }

  Sinfa run() {
    while (!left_.empty() && !cells_.empty() && play_round()) {
    }
    for (const auto feature : left_) result_.determined.push_back(features_[feature].name);
    return std::move(result_);
  }

 private:
  [[nodiscard]] double responses() const {
    double sum = 0.0;
    for (const auto& cell : cells_) sum += cell.count;
    return sum;
  }

  /// False if nothing is left to choose from.
  bool play_round() {
    SinfaRound round{.responses = responses(), .candidates = {}, .chosen = {}};
    double largest = -1.0;
    for (const auto feature : left_) {
      round.candidates.push_back(information_of(features_[feature]));
      largest = std::max(largest, round.candidates.back().relative.value_or(-1.0));
    }
    if (largest < 0.0) return false;
    std::vector<std::size_t> not_chosen;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const auto& relative = round.candidates[i].relative;
      if (!relative || *relative < largest - kTie) {
        not_chosen.push_back(left_[i]);
        continue;
      }
      round.chosen.push_back(features_[left_[i]].name);
      hold(left_[i]);
    }
    left_ = std::move(not_chosen);
    result_.rounds.push_back(std::move(round));
    return true;
  }

  void hold(std::size_t feature) {
    held_.push_back(feature);
    std::erase_if(cells_, [&](const Cell& cell) { return !agrees(features_[feature], cell); });
  }

  /// Within each combination of held values (which stimulus and response share).
  [[nodiscard]] HeldInformation information_of(const Feature& feature) const {
    using Key = std::vector<std::string>;
    std::map<Key, double> blocks;
    std::map<Key, double> stimuli;
    std::map<Key, double> responses;
    std::map<Key, double> pairs;
    for (const auto& cell : cells_) {
      Key key;
      for (const auto held : held_) key.push_back(features_[held].of_stimuli[cell.stimulus]);
      blocks[key] += cell.count;
      key.push_back(feature.of_stimuli[cell.stimulus]);
      stimuli[key] += cell.count;
      key.push_back(feature.of_responses[cell.response]);
      pairs[key] += cell.count;
      key.erase(key.end() - 2);
      responses[key] += cell.count;
    }
    const double n = result_.responses;
    const double of_blocks = sum_of_logs(blocks);
    const double of_stimuli = sum_of_logs(stimuli);
    HeldInformation found{
        .feature = feature.name,
        .entropy = std::max(0.0, (of_blocks - of_stimuli) / n),
        .transmitted = std::max(
            0.0, (of_blocks - of_stimuli - sum_of_logs(responses) + sum_of_logs(pairs)) / n)};
    if (stimuli.size() > blocks.size()) found.relative = found.transmitted / found.entropy;
    return found;
  }

  std::span<const Feature> features_;
  std::vector<Cell> cells_;        ///< that still count
  std::vector<std::size_t> left_;  ///< features not held yet
  std::vector<std::size_t> held_;
  Sinfa result_;
};

}  // namespace

Sinfa sinfa(const ConfusionMatrix& matrix, std::span<const Feature> features) {
  assert(std::ranges::all_of(features, [&](const Feature& feature) {
    return feature.of_stimuli.size() == matrix.stimuli().size() &&
           feature.of_responses.size() == matrix.responses().size();
  }));
  return Analysis{matrix, features}.run();
}

}  // namespace bimodal::analysis
