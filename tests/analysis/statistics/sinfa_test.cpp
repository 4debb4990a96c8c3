#include "analysis/statistics/sinfa.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/statistics/information.hpp"

namespace bimodal::analysis {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kExact = 1e-12;

Feature feature(std::string name, std::vector<std::string> values) {
  return {.name = std::move(name), .of_stimuli = values, .of_responses = values};
}

ConfusionMatrix example() {
  const std::vector<std::string> labels{"p", "b", "m", "t", "d", "n"};
  return {labels, labels, {40, 6, 2, 9,  2, 1, 7, 35, 6, 2, 8,  2, 1, 5, 44, 0, 3, 7,
                           12, 2, 0, 38, 6, 2, 2, 9,  2, 8, 33, 6, 1, 2, 10, 1, 5, 41}};
}

std::vector<Feature> features() {
  return {feature("voicing", {"-", "+", "+", "-", "+", "+"}),
          feature("nasality", {"-", "-", "+", "-", "-", "+"}),
          feature("place", {"l", "l", "l", "a", "a", "a"})};
}

/// numpy 1.24.2, block by block: T = sum p log2(p_ij p_b / (p_i p_j)), H = -sum p_i log2(p_i /
/// p_b).
TEST(Sinfa, IsThatOfNumpyRoundByRound) {
  const auto found = sinfa(example(), features());
  EXPECT_EQ(found.responses, 360);
  ASSERT_EQ(found.rounds.size(), 3U);
  EXPECT_THAT(found.rounds[0].chosen, ElementsAre("nasality"));
  EXPECT_THAT(found.rounds[1].chosen, ElementsAre("voicing"));
  EXPECT_THAT(found.rounds[2].chosen, ElementsAre("place"));
  EXPECT_EQ(found.rounds[1].responses, 321);
  EXPECT_EQ(found.rounds[2].responses, 286);
  const auto& first = found.rounds[0].candidates;
  EXPECT_NEAR(first[0].transmitted, 0.4033709197767143, kExact);
  EXPECT_NEAR(first[1].relative.value(), 0.4766925837210843, kExact);
  EXPECT_NEAR(first[2].entropy, 1.0, kExact);
  const auto& second = found.rounds[1].candidates;
  EXPECT_EQ(second[0].feature, "voicing");
  EXPECT_NEAR(second[0].entropy, 0.6072257764093895, kExact);
  EXPECT_NEAR(second[0].relative.value(), 0.36498046955426083, kExact);
  EXPECT_NEAR(second[1].transmitted, 0.25728739312047083, kExact);
  EXPECT_NEAR(found.rounds[2].candidates[0].transmitted, 0.2358077962578437, kExact);
  EXPECT_NEAR(found.rounds[2].candidates[0].entropy, 0.794400630278629, kExact);
}

TEST(Sinfa, BeginsWithTheInformationOfEachFeatureAlone) {
  const auto found = sinfa(example(), features());
  const auto all = features();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& one = all[i];
    const auto alone = information(grouped(example(), one.of_stimuli, one.of_responses)).value();
    EXPECT_NEAR(found.rounds[0].candidates[i].transmitted, alone.transmitted, kExact);
    EXPECT_NEAR(found.rounds[0].candidates[i].relative.value(), alone.relative.value(), kExact);
  }
}

TEST(Sinfa, HoldsFeaturesThatTieTogetherAndTellsWhatIsDetermined) {
  auto all = features();
  all.push_back(feature("oral", {"yes", "yes", "no", "yes", "yes", "no"}));  // as nasality
  all.push_back(feature("speech", {"s", "s", "s", "s", "s", "s"}));
  const auto found = sinfa(example(), all);
  EXPECT_THAT(found.rounds[0].chosen, ElementsAre("nasality", "oral"));
  EXPECT_EQ(found.rounds[1].responses, 321);
  EXPECT_THAT(found.determined, ElementsAre("speech"));
}

TEST(Sinfa, LeavesOutWhatAFeatureDoesNotApplyTo) {
  const ConfusionMatrix matrix{{"p", "b"}, {"p", "b", "blank"}, {5, 1, 2, 0, 6, 1}};
  const std::vector<Feature> voicing{
      {.name = "voicing", .of_stimuli = {"-", "+"}, .of_responses = {"-", "+", ""}}};
  const auto found = sinfa(matrix, voicing);
  EXPECT_EQ(found.responses, 12);
  EXPECT_EQ(found.left_out, 3);
}

TEST(Sinfa, OfNothingHasNoRounds) {
  EXPECT_THAT(sinfa({{"p"}, {"p"}, {0}}, std::vector<Feature>{feature("v", {"-"})}).rounds,
              IsEmpty());
  EXPECT_THAT(sinfa(example(), {}).rounds, IsEmpty());
}

}  // namespace
}  // namespace bimodal::analysis
