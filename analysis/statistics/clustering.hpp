#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/statistics/confusion_matrix.hpp"
#include "analysis/statistics/dissimilarity.hpp"

namespace bimodal::analysis {

/// How unlike two clusters are: as their nearest members, their farthest, or all pairs on average.
enum class Linkage { Single, Complete, Average };

/// Two clusters that became one. Clusters 0 to n - 1 are the n things themselves; the k-th merge,
/// from 0, makes the cluster n + k.
struct Merge {
  std::size_t one = 0;
  std::size_t other = 0;    ///< > one
  double height = 0.0;      ///< how unlike the two are
  std::size_t members = 0;  ///< of the new cluster
};

/// The n - 1 merges, each of the two clusters that are least unlike (the first two where several
/// are), in their order; their heights never fall.
[[nodiscard]] std::vector<Merge> cluster(const Dissimilarities& unlike, Linkage linkage);

/// Things so ordered that every cluster's members lie side by side, as a dendrogram draws them.
[[nodiscard]] std::vector<std::size_t> leaf_order(const std::vector<Merge>& merges);

/// The classes after so many merges: the members of each, ascending, classes by their first one.
[[nodiscard]] std::vector<std::vector<std::size_t>> classes_after(const std::vector<Merge>& merges,
                                                                  std::size_t count);

/// Of the responses to the members of a class, the part that names a member. `members` are labels.
[[nodiscard]] double kept_within(const ConfusionMatrix& matrix,
                                 const std::vector<std::string>& members);

/// The fewest merges after which every class keeps at least `criterion` of the responses to its
/// members: visemes by the rule of Walden et al. (1977, J. Speech Hear. Res. 20, 130-145), who
/// asked for three quarters or so. `labels` are those of the things clustered. All merges, where
/// even a single class keeps less.
[[nodiscard]] std::size_t merges_until_kept(const ConfusionMatrix& matrix,
                                            const std::vector<std::string>& labels,
                                            const std::vector<Merge>& merges,
                                            double criterion);

}  // namespace bimodal::analysis
