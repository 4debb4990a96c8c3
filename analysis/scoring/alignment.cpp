#include "analysis/scoring/alignment.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

#include "analysis/scoring/phone_features.hpp"

namespace bimodal::analysis {

namespace {

/// Cost, matches and insertions as one number that is least for the best alignment: the least cost
/// outweighs any number of matches, and a match any number of insertions.
using Rank = std::int64_t;
constexpr Rank kInsertion = 1;
constexpr Rank kMatch = -(Rank{1} << 18);
constexpr Rank kCost = Rank{1} << 36;  ///< a fifteenth of the cost of a deletion
constexpr Rank kEdit = kCost * kAllFeatures;
constexpr Rank kForbidden = Rank{1} << 58;

/// Over pairs of boundaries: before or behind phones of the stimulus (rows) and of the answer.
template <typename Value>
class Lattice {
 public:
  Lattice(std::size_t rows, std::size_t columns) : columns_{columns}, values_(rows * columns) {}

  Value& at(std::size_t row, std::size_t column) { return values_[row * columns_ + column]; }

  const Value& at(std::size_t row, std::size_t column) const {
    return values_[row * columns_ + column];
  }

 private:
  std::size_t columns_;
  std::vector<Value> values_;
};

/// How many ways lead to (or on from) a boundary. So that an alignment is counted once, what is
/// inserted between two pairs comes before what is deleted there: nothing is inserted right behind
/// a deletion.
struct Ways {
  double after_deletion = 0.0;  ///< the step before the boundary is (or was) a deletion
  double otherwise = 0.0;
};

/// Both phone sequences, and what is best from each boundary on.
class Comparison {
 public:
  Comparison(std::span<const Phone> stimulus, std::span<const Phone> answer, AlignmentCosts costs)
      : stimulus_{stimulus},
        answer_{answer},
        costs_{costs},
        before_{stimulus.size() + 1, answer.size() + 1},
        behind_{stimulus.size() + 1, answer.size() + 1} {
    rank_before();
    rank_behind();
  }

  [[nodiscard]] Rank best() const { return behind_.at(0, 0); }

  /// Whether a best alignment sets the two phones against each other.
  [[nodiscard]] bool pairs(std::size_t i, std::size_t j) const {
    return before_.at(i, j) + step(i, j) + behind_.at(i + 1, j + 1) == best();
  }

  /// Whether a best alignment deletes stimulus phone i before the answer's phone j.
  [[nodiscard]] bool deletes(std::size_t i, std::size_t j) const {
    return before_.at(i, j) + kEdit + behind_.at(i + 1, j) == best();
  }

  /// Whether a best alignment inserts the answer's phone j before stimulus phone i.
  [[nodiscard]] bool inserts(std::size_t i, std::size_t j) const {
    return before_.at(i, j) + kEdit + kInsertion + behind_.at(i, j + 1) == best();
  }

 private:
  [[nodiscard]] Rank step(std::size_t i, std::size_t j) const {
    const Phone stimulus = stimulus_[i];
    const Phone answer = answer_[j];
    if (stimulus == answer) return kMatch;
    if (is_vowel(stimulus) != is_vowel(answer)) return kForbidden;
    if (costs_ == AlignmentCosts::Unit) return kEdit;
    return kCost * feature_difference(stimulus, answer);
  }

  void rank_before() {
    for (std::size_t i = 0; i <= stimulus_.size(); ++i) {
      for (std::size_t j = 0; j <= answer_.size(); ++j) {
        Rank least = i == 0 && j == 0 ? 0 : std::numeric_limits<Rank>::max();
        if (i > 0) least = std::min(least, before_.at(i - 1, j) + kEdit);
        if (j > 0) least = std::min(least, before_.at(i, j - 1) + kEdit + kInsertion);
        if (i > 0 && j > 0) {
          least = std::min(least, before_.at(i - 1, j - 1) + step(i - 1, j - 1));
        }
        before_.at(i, j) = least;
      }
    }
  }

  void rank_behind() {
    for (std::size_t i = stimulus_.size() + 1; i-- > 0;) {
      for (std::size_t j = answer_.size() + 1; j-- > 0;) {
        const bool more_stimulus = i < stimulus_.size();
        const bool more_answer = j < answer_.size();
        Rank least = more_stimulus || more_answer ? std::numeric_limits<Rank>::max() : 0;
        if (more_stimulus) least = std::min(least, behind_.at(i + 1, j) + kEdit);
        if (more_answer) least = std::min(least, behind_.at(i, j + 1) + kEdit + kInsertion);
        if (more_stimulus && more_answer) {
          least = std::min(least, behind_.at(i + 1, j + 1) + step(i, j));
        }
        behind_.at(i, j) = least;
      }
    }
  }

  std::span<const Phone> stimulus_;
  std::span<const Phone> answer_;
  AlignmentCosts costs_;
  Lattice<Rank> before_;
  Lattice<Rank> behind_;
};

/// Ways from the beginning to each boundary along best alignments.
Lattice<Ways> ways_to(const Comparison& comparison, std::size_t stimulus, std::size_t answer) {
  Lattice<Ways> ways{stimulus + 1, answer + 1};
  ways.at(0, 0).otherwise = 1.0;
  for (std::size_t i = 0; i <= stimulus; ++i) {
    for (std::size_t j = 0; j <= answer; ++j) {
      auto& here = ways.at(i, j);
      if (j > 0 && comparison.inserts(i, j - 1)) here.otherwise += ways.at(i, j - 1).otherwise;
      if (i > 0 && comparison.deletes(i - 1, j)) {
        const auto& from = ways.at(i - 1, j);
        here.after_deletion += from.after_deletion + from.otherwise;
      }
      if (i > 0 && j > 0 && comparison.pairs(i - 1, j - 1)) {
        const auto& from = ways.at(i - 1, j - 1);
        here.otherwise += from.after_deletion + from.otherwise;
      }
    }
  }
  return ways;
}

/// Ways from each boundary to the end along best alignments.
Lattice<Ways> ways_from(const Comparison& comparison, std::size_t stimulus, std::size_t answer) {
  Lattice<Ways> ways{stimulus + 1, answer + 1};
  for (std::size_t i = stimulus + 1; i-- > 0;) {
    for (std::size_t j = answer + 1; j-- > 0;) {
      auto& here = ways.at(i, j);
      if (i == stimulus && j == answer) here.after_deletion = 1.0;
      if (i < stimulus && comparison.deletes(i, j)) {
        here.after_deletion += ways.at(i + 1, j).after_deletion;
      }
      if (i < stimulus && j < answer && comparison.pairs(i, j)) {
        here.after_deletion += ways.at(i + 1, j + 1).otherwise;
      }
      here.otherwise = here.after_deletion;
      if (j < answer && comparison.inserts(i, j)) here.otherwise += ways.at(i, j + 1).otherwise;
    }
  }
  return ways;
}

void add(std::vector<PartnerCount>& partners, const PartnerCount& more) {
  const auto at = std::ranges::lower_bound(partners, more.partner, {}, &PartnerCount::partner);
  if (at != partners.end() && at->partner == more.partner) {
    at->alignments += more.alignments;
  } else {
    partners.insert(at, more);
  }
}

/// The three things that a rank is made of.
Alignment read_rank(Rank rank) {
  const Rank cost = (rank + kCost + kMatch) / kCost;  // matches and insertions are less than kCost
  const Rank rest = rank - cost * kCost;
  const Rank matches = (rest + kMatch + 1) / kMatch;  // insertions are less than a match
  Alignment read;
  read.cost = static_cast<double>(cost) / kAllFeatures;
  read.matches = static_cast<int>(matches);
  read.insertions = static_cast<int>(rest - matches * kMatch);
  return read;
}

auto merit(const Alignment& alignment) {
  return std::tuple{alignment.cost, -alignment.matches, alignment.insertions};
}

}  // namespace

Alignment align(std::span<const Phone> stimulus,
                std::span<const Phone> answer,
                AlignmentCosts costs) {
  assert(stimulus.size() + answer.size() < (std::size_t{1} << 17));
  const Comparison comparison{stimulus, answer, costs};
  const auto to = ways_to(comparison, stimulus.size(), answer.size());
  const auto from = ways_from(comparison, stimulus.size(), answer.size());
  Alignment found = read_rank(comparison.best());
  found.alignments = from.at(0, 0).otherwise;
  found.partners.resize(stimulus.size());
  for (std::size_t i = 0; i < stimulus.size(); ++i) {
    for (std::size_t j = 0; j <= answer.size(); ++j) {
      const auto& here = to.at(i, j);
      const double ways = here.after_deletion + here.otherwise;
      if (comparison.deletes(i, j)) {
        add(found.partners[i], {std::nullopt, ways * from.at(i + 1, j).after_deletion});
      }
      if (j < answer.size() && comparison.pairs(i, j)) {
        add(found.partners[i], {answer[j], ways * from.at(i + 1, j + 1).otherwise});
      }
    }
  }
  return found;
}

AlignmentWithAny align_with_any(std::span<const Phone> stimulus,
                                std::span<const Pronunciation> answers,
                                AlignmentCosts costs) {
  assert(!answers.empty());
  AlignmentWithAny found;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    auto next = align(stimulus, answers[i], costs);
    const AlignmentWithAny::Best best{.pronunciation = i, .alignments = next.alignments};
    if (i == 0 || merit(next) < merit(found.alignment)) {
      found = {.alignment = std::move(next), .best = {best}};
    } else if (merit(next) == merit(found.alignment)) {
      found.alignment.alignments += next.alignments;
      found.best.push_back(best);
      for (std::size_t place = 0; place < stimulus.size(); ++place) {
        for (const auto& more : next.partners[place]) add(found.alignment.partners[place], more);
      }
    }
  }
  return found;
}

}  // namespace bimodal::analysis
