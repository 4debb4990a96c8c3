#include "analysis/statistics/clustering.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <tuple>
#include <utility>

namespace bimodal::analysis {

namespace {

struct Cluster {
  std::size_t number;
  std::size_t members;
};

double joined(double one, double other, const Cluster& first, const Cluster& second, Linkage how) {
  switch (how) {
    case Linkage::Single:
      return std::min(one, other);
    case Linkage::Complete:
      return std::max(one, other);
    case Linkage::Average:
      break;
  }
  const auto a = static_cast<double>(first.members);
  const auto b = static_cast<double>(second.members);
  return (a * one + b * other) / (a + b);
}

/// The clusters that there are still, and how unlike they are.
class Forest {
 public:
  explicit Forest(const Dissimilarities& unlike) {
    for (std::size_t i = 0; i < unlike.size(); ++i) {
      clusters_.push_back({i, 1});
      auto& row = unlike_.emplace_back();
      for (std::size_t j = 0; j < unlike.size(); ++j) row.push_back(unlike.between(i, j));
    }
  }

  Merge merge_nearest(std::size_t number, Linkage linkage) {
    std::size_t at = 0;
    std::size_t with = 1;
    for (std::size_t i = 0; i < clusters_.size(); ++i) {
      for (std::size_t j = i + 1; j < clusters_.size(); ++j) {
        if (unlike_[i][j] < unlike_[at][with]) std::tie(at, with) = std::pair{i, j};
      }
    }
    const auto first = clusters_[at];
    const auto second = clusters_[with];
    const Merge merge{.one = std::min(first.number, second.number),
                      .other = std::max(first.number, second.number),
                      .height = unlike_[at][with],
                      .members = first.members + second.members};
    for (std::size_t k = 0; k < clusters_.size(); ++k) {
      unlike_[at][k] = unlike_[k][at] =
          joined(unlike_[at][k], unlike_[with][k], first, second, linkage);
    }
    clusters_[at] = {number, merge.members};
    const auto gone = static_cast<std::ptrdiff_t>(with);
    clusters_.erase(clusters_.begin() + gone);
    unlike_.erase(unlike_.begin() + gone);
    for (auto& row : unlike_) row.erase(row.begin() + gone);
    return merge;
  }

 private:
  std::vector<Cluster> clusters_;
  std::vector<std::vector<double>> unlike_;
};

std::size_t things(const std::vector<Merge>& merges) {
  return merges.size() + 1;
}

}  // namespace

std::vector<Merge> cluster(const Dissimilarities& unlike, Linkage linkage) {
  std::vector<Merge> merges;
  Forest forest{unlike};
  for (std::size_t k = 1; k < unlike.size(); ++k) {
    merges.push_back(forest.merge_nearest(unlike.size() + k - 1, linkage));
  }
  return merges;
}

std::vector<std::size_t> leaf_order(const std::vector<Merge>& merges) {
  std::vector<std::size_t> order;
  std::vector<std::size_t> open{things(merges) + merges.size() - 1};  // the last cluster
  while (!open.empty()) {
    const auto now = open.back();
    open.pop_back();
    if (now < things(merges)) {
      order.push_back(now);
      continue;
    }
    const auto& merge = merges[now - things(merges)];
    open.push_back(merge.other);
    open.push_back(merge.one);
  }
  return order;
}

std::vector<std::vector<std::size_t>> classes_after(const std::vector<Merge>& merges,
                                                    std::size_t count) {
  assert(count <= merges.size());
  const auto n = things(merges);
  std::vector<std::vector<std::size_t>> members(n + count);
  for (std::size_t i = 0; i < n; ++i) members[i] = {i};
  for (std::size_t k = 0; k < count; ++k) {
    auto& whole = members[n + k];
    for (const auto part : {merges[k].one, merges[k].other}) {
      whole.insert(whole.end(), members[part].begin(), members[part].end());
      members[part].clear();
    }
    std::ranges::sort(whole);
  }
  std::erase_if(members, [](const auto& some) { return some.empty(); });
  std::ranges::sort(members);
  return members;
}

double kept_within(const ConfusionMatrix& matrix, const std::vector<std::string>& members) {
  const auto is_member = [&](const std::string& label) {
    return std::ranges::find(members, label) != members.end();
  };
  double kept = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    if (!is_member(matrix.stimuli()[i])) continue;
    all += matrix.row_total(i);
    for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
      if (is_member(matrix.responses()[j])) kept += matrix.count(i, j);
    }
  }
  return all <= 0.0 ? 0.0 : kept / all;
}

std::size_t merges_until_kept(const ConfusionMatrix& matrix,
                              const std::vector<std::string>& labels,
                              const std::vector<Merge>& merges,
                              double criterion) {
  const auto keeps = [&](const std::vector<std::size_t>& members) {
    std::vector<std::string> names;
    for (const auto member : members) names.push_back(labels[member]);
    return kept_within(matrix, names) >= criterion;
  };
  for (std::size_t count = 0; count < merges.size(); ++count) {
    if (std::ranges::all_of(classes_after(merges, count), keeps)) return count;
  }
  return merges.size();
}

}  // namespace bimodal::analysis
