#include "analysis/scoring/alignment.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace bimodal::analysis {

namespace {

/// Cost and matches as one number that is least for the best alignment: an edit outweighs any
/// number of matches.
constexpr int kEdit = 1 << 16;
constexpr int kMatch = -1;
constexpr int kForbidden = 1 << 28;

int step(Phone stimulus, Phone answer) {
  if (stimulus == answer) return kMatch;
  return is_vowel(stimulus) == is_vowel(answer) ? kEdit : kForbidden;
}

/// Best scores of aligning everything before (or behind) a pair of boundaries.
class Scores {
 public:
  Scores(std::size_t rows, std::size_t columns) : columns_{columns}, scores_(rows * columns) {}

  int& at(std::size_t row, std::size_t column) { return scores_[row * columns_ + column]; }

 private:
  std::size_t columns_;
  std::vector<int> scores_;
};

Scores score_before(std::span<const Phone> stimulus, std::span<const Phone> answer) {
  Scores best{stimulus.size() + 1, answer.size() + 1};
  for (std::size_t i = 0; i <= stimulus.size(); ++i) {
    for (std::size_t j = 0; j <= answer.size(); ++j) {
      if (i == 0 && j == 0) continue;
      int least = std::numeric_limits<int>::max();
      if (i > 0) least = std::min(least, best.at(i - 1, j) + kEdit);
      if (j > 0) least = std::min(least, best.at(i, j - 1) + kEdit);
      if (i > 0 && j > 0) {
        least = std::min(least, best.at(i - 1, j - 1) + step(stimulus[i - 1], answer[j - 1]));
      }
      best.at(i, j) = least;
    }
  }
  return best;
}

Scores score_behind(std::span<const Phone> stimulus, std::span<const Phone> answer) {
  Scores best{stimulus.size() + 1, answer.size() + 1};
  for (std::size_t i = stimulus.size() + 1; i-- > 0;) {
    for (std::size_t j = answer.size() + 1; j-- > 0;) {
      if (i == stimulus.size() && j == answer.size()) continue;
      int least = std::numeric_limits<int>::max();
      if (i < stimulus.size()) least = std::min(least, best.at(i + 1, j) + kEdit);
      if (j < answer.size()) least = std::min(least, best.at(i, j + 1) + kEdit);
      if (i < stimulus.size() && j < answer.size()) {
        least = std::min(least, best.at(i + 1, j + 1) + step(stimulus[i], answer[j]));
      }
      best.at(i, j) = least;
    }
  }
  return best;
}

void keep_different(std::vector<Partner>& partners) {
  std::ranges::sort(partners);
  partners.erase(std::unique(partners.begin(), partners.end()), partners.end());
}

}  // namespace

Alignment align(std::span<const Phone> stimulus, std::span<const Phone> answer) {
  assert(stimulus.size() + answer.size() < 4096);
  auto before = score_before(stimulus, answer);
  auto behind = score_behind(stimulus, answer);
  const int best = behind.at(0, 0);
  Alignment found;
  found.cost = (best + kEdit - 1) / kEdit;
  found.matches = found.cost * kEdit - best;
  found.partners.resize(stimulus.size());
  for (std::size_t i = 0; i < stimulus.size(); ++i) {
    auto& partners = found.partners[i];
    for (std::size_t j = 0; j <= answer.size(); ++j) {
      if (before.at(i, j) + kEdit + behind.at(i + 1, j) == best) partners.emplace_back();
      if (j == answer.size()) continue;
      if (before.at(i, j) + step(stimulus[i], answer[j]) + behind.at(i + 1, j + 1) == best) {
        partners.emplace_back(answer[j]);
      }
    }
    keep_different(partners);
  }
  return found;
}

Alignment align_with_any(std::span<const Phone> stimulus, std::span<const Pronunciation> answers) {
  assert(!answers.empty());
  Alignment best = align(stimulus, answers.front());
  for (const auto& answer : answers.subspan(1)) {
    auto other = align(stimulus, answer);
    const auto rank = std::pair{other.cost, -other.matches};
    const auto best_rank = std::pair{best.cost, -best.matches};
    if (rank < best_rank) {
      best = std::move(other);
    } else if (rank == best_rank) {
      for (std::size_t i = 0; i < stimulus.size(); ++i) {
        auto& partners = best.partners[i];
        partners.insert(partners.end(), other.partners[i].begin(), other.partners[i].end());
        keep_different(partners);
      }
    }
  }
  return best;
}

}  // namespace bimodal::analysis
