#include "stimuli/alignment/phone_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal {
namespace {

using enum Phone;

class PhonePath : public ::testing::Test {
 public:
  PhonePath() : model_{AcousticModel::installed()} {}

 protected:
  [[nodiscard]] UnitScores random_scores(std::size_t frames, std::size_t units, Seed seed) const {
    const std::vector<PhoneUnit> wanted(units);
    UnitScores scores{frames, wanted};
    Random random{seed};
    for (std::size_t unit = 0; unit < units; ++unit) {
      for (auto& states : scores.of(unit)) {
        for (float& score : states) score = static_cast<float>(4.0 * random.normal());
      }
    }
    return scores;
  }

  [[nodiscard]] double likelihood(const PhoneGraph& graph,
                                  const std::vector<PathStep>& path,
                                  const UnitScores& scores) const {
    double sum = 0.0;
    for (const auto& [node, first, frames] : path) {
      sum += phone_likelihood(graph[node], first, frames, scores, model_);
    }
    return sum;
  }

  AcousticModel model_;
};

PhoneGraph chain(std::initializer_list<Phone> phones) {
  PhoneGraph graph;
  for (const Phone phone : phones) {
    const auto at = graph.size();
    graph.push_back({.phone = phone, .unit = at, .before = {}});
    if (at > 0) graph.back().before = {at - 1};
  }
  return graph;
}

TEST_F(PhonePath, IsTheBestOfAllSegmentations) {
  const auto graph = chain({Rest, S, UW, Rest});
  constexpr std::size_t kFrames = 20;
  for (Seed seed = 0; seed < 30; ++seed) {
    const auto scores = random_scores(kFrames, graph.size(), seed);
    double best = -std::numeric_limits<double>::infinity();
    std::vector<std::size_t> best_starts;
    for (std::size_t a = 3; a < kFrames; ++a) {
      for (std::size_t b = a + 3; b < kFrames; ++b) {
        for (std::size_t c = b + 3; c + 3 <= kFrames; ++c) {
          const double sum = likelihood(
              graph, {{0, 0, a}, {1, a, b - a}, {2, b, c - b}, {3, c, kFrames - c}}, scores);
          if (sum <= best) continue;
          best = sum;
          best_starts = {0, a, b, c};
        }
      }
    }
    const auto path = best_path(graph, scores, model_);
    ASSERT_TRUE(path);
    std::vector<std::size_t> starts;
    for (const auto& step : *path) starts.push_back(step.first_frame);
    EXPECT_EQ(starts, best_starts) << "seed " << seed;
  }
}

TEST_F(PhonePath, TakesTheLikelierBranch) {
  PhoneGraph graph = chain({Rest, S, UW});
  graph.push_back({.phone = AA, .unit = 3, .before = {0}});
  graph.push_back({.phone = Rest, .unit = 4, .before = {2, 3}});
  int long_ones = 0;
  for (Seed seed = 0; seed < 30; ++seed) {
    const auto scores = random_scores(15, graph.size(), seed);
    const auto path = best_path(graph, scores, model_).value();
    EXPECT_TRUE(path.size() == 3 || path.size() == 4);
    if (path.size() == 4) ++long_ones;
    for (const bool branch : {false, true}) {  // neither branch by itself does better
      auto only = graph;
      only.back().before = {branch ? 2U : 3U};
      const auto other = best_path(only, scores, model_).value();
      EXPECT_GE(likelihood(graph, path, scores), likelihood(only, other, scores) - 1e-4);
    }
  }
  EXPECT_GT(long_ones, 0);
  EXPECT_LT(long_ones, 30);
}

TEST_F(PhonePath, IsWholeWhateverTheNumberOfFrames) {
  const auto graph = chain({Rest, B, IH, N, Rest});
  for (const std::size_t frames : {15U, 16U, 255U, 256U, 257U, 258U, 512U, 513U, 514U, 1000U}) {
    const auto scores = random_scores(frames, graph.size(), frames);
    const auto path = best_path(graph, scores, model_);
    ASSERT_TRUE(path) << frames;
    ASSERT_EQ(path->size(), graph.size());
    std::size_t at = 0;
    for (const auto& step : *path) {
      EXPECT_EQ(step.first_frame, at);
      EXPECT_GE(step.frames, kStates);
      at += step.frames;
    }
    EXPECT_EQ(at, frames);
  }
}

TEST_F(PhonePath, IsTheSameInManyFramesAsPieceByPiece) {
  // In 4000 frames paths are given up; each unit fits in a part of its own.
  const auto graph = chain({Rest, AA, IY, Rest});
  constexpr std::size_t kFrames = 4000;
  auto scores = random_scores(kFrames, graph.size(), 9);
  constexpr std::array<std::size_t, 5> kStarts{0, 1000, 2000, 3500, kFrames};
  for (std::size_t unit = 0; unit < graph.size(); ++unit) {
    for (std::size_t frame = kStarts[unit]; frame < kStarts[unit + 1]; ++frame) {
      for (float& score : scores.of(unit)[frame]) score += 30.0F;
    }
  }
  const auto path = best_path(graph, scores, model_).value();
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(path[i].first_frame), static_cast<double>(kStarts[i]), 2.0);
  }
}

TEST_F(PhonePath, IsFoundInManyFramesEvenIfItSeemedHopeless) {
  // The last rest fits nothing but must be passed; what is given up must be taken up again.
  const auto graph = chain({Rest, AA, Rest});
  constexpr std::size_t kFrames = 4000;
  auto scores = random_scores(kFrames, graph.size(), 10);
  for (const std::size_t unit : {1U, 2U}) {
    for (auto& states : scores.of(unit)) states.fill(-2000.0F);
  }
  const auto path = best_path(graph, scores, model_).value();
  EXPECT_EQ(path.size(), 3U);
  EXPECT_EQ(path.back().first_frame + path.back().frames, kFrames);
}

TEST_F(PhonePath, DoesNotExistInTooFewFrames) {
  const auto graph = chain({Rest, B, IH, N, Rest});
  EXPECT_FALSE(best_path(graph, random_scores(14, graph.size(), 1), model_));
  EXPECT_FALSE(best_path(graph, random_scores(0, graph.size(), 1), model_));
  EXPECT_FALSE(best_path({}, random_scores(20, 1, 1), model_));
}

TEST_F(PhonePath, FreeSequenceIsAtLeastAsLikelyAsAnyOther) {
  const auto graph = chain({Rest, S, UW, AA});
  for (Seed seed = 0; seed < 30; ++seed) {
    const auto scores = random_scores(40, graph.size(), seed);
    const double free = free_likelihood(graph, 0, 40, scores, model_);
    const auto path = best_path(graph, scores, model_).value();
    EXPECT_GE(free, likelihood(graph, path, scores) - 1e-4);
  }
}

}  // namespace
}  // namespace bimodal
