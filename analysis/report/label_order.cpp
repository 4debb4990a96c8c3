#include "analysis/report/label_order.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "analysis/statistics/clustering.hpp"
#include "analysis/statistics/dissimilarity.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/timeline/phone.hpp"

namespace bimodal::analysis {

namespace {

using Labels = std::vector<std::string>;

/// The labels sorted by rank(label), those of equal rank as given.
template <typename Rank>
std::vector<std::size_t> ranked(const Labels& labels, const Rank& rank) {
  std::vector<std::size_t> order(labels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return rank(labels[i]); });
  return order;
}

ConfusionMatrix pick(const ConfusionMatrix& matrix,
                     const std::vector<std::size_t>& rows,
                     const std::vector<std::size_t>& columns) {
  Labels stimuli;
  Labels responses;
  std::vector<double> counts;
  for (const auto j : columns) responses.push_back(matrix.responses()[j]);
  for (const auto i : rows) {
    stimuli.push_back(matrix.stimuli()[i]);
    for (const auto j : columns) counts.push_back(matrix.count(i, j));
  }
  return {std::move(stimuli), std::move(responses), std::move(counts)};
}

template <typename Rank>
ConfusionMatrix sorted(const ConfusionMatrix& matrix, const Rank& rank) {
  return pick(matrix, ranked(matrix.stimuli(), rank), ranked(matrix.responses(), rank));
}

constexpr std::size_t kNoRank = static_cast<std::size_t>(-1);

std::size_t place_rank(const std::string& label) {
  const auto phone = phone_from_symbol(label);
  return phone && *phone != Phone::Rest ? static_cast<std::size_t>(*phone) : kNoRank;
}

ConfusionMatrix by_place(const ConfusionMatrix& matrix) {
  const auto is_phone = [](const std::string& label) { return place_rank(label) != kNoRank; };
  if (std::ranges::none_of(matrix.stimuli(), is_phone)) {
    throw Error{
        "ordering a confusion matrix by place: no stimulus is a phone of the ARPAbet; take "
        "--order given or clusters"};
  }
  return sorted(matrix, place_rank);
}

ConfusionMatrix by_clusters(const ConfusionMatrix& matrix) {
  const auto unlike = dissimilarities(matrix, DissimilarityMeasure::Phi);
  Labels leaves;
  for (const auto leaf : leaf_order(cluster(unlike, Linkage::Average))) {
    leaves.push_back(unlike.labels()[leaf]);
  }
  return sorted(matrix, [&leaves](const std::string& label) {
    return static_cast<std::size_t>(std::ranges::find(leaves, label) - leaves.begin());
  });
}

}  // namespace

std::string_view in_words(LabelOrder order) {
  switch (order) {
    case LabelOrder::Given:
      return "as given";
    case LabelOrder::Place:
      return "place of articulation, front to back";
    case LabelOrder::Clusters:
      return "leaves of the dendrogram (average linkage, phi dissimilarity)";
  }
  return {};
}

ConfusionMatrix reordered(const ConfusionMatrix& matrix, LabelOrder order) {
  switch (order) {
    case LabelOrder::Given:
      return matrix;
    case LabelOrder::Place:
      return by_place(matrix);
    case LabelOrder::Clusters:
      return by_clusters(matrix);
  }
  return matrix;
}

}  // namespace bimodal::analysis
