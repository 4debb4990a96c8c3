#include "protocols/observers/closed_set.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bimodal::protocols {
namespace {

using ::testing::DoubleEq;
using ::testing::DoubleNear;
using ::testing::ElementsAre;

const Pronunciation kBa{Phone::B, Phone::AA};
const Pronunciation kWa{Phone::W, Phone::AA};
const Pronunciation kStew{Phone::S, Phone::T, Phone::UW};

TEST(ClosedSet, SharesOutWhatTheTableSaysAmongTheOptions) {
  auto table = identity_confusions();
  table(Phone::B, Phone::B) = 0.3;
  table(Phone::B, Phone::W) = 0.1;
  table(Phone::B, Phone::D) = 0.6;
  const std::vector<Pronunciation> options{kBa, kWa};
  EXPECT_THAT(closed_set_probabilities(kBa, options, table),
              ElementsAre(DoubleEq(0.75), DoubleEq(0.25)));
}

TEST(ClosedSet, RecognisesWhatIsClear) {
  const std::vector<Pronunciation> options{kBa, kWa, kStew};
  EXPECT_THAT(closed_set_probabilities(kWa, options, identity_confusions()),
              ElementsAre(DoubleNear(0.0, 1e-5), DoubleNear(1.0, 1e-5), 0.0));
}

TEST(ClosedSet, ChoosesTheNearestWhereNoOptionIsPossible) {
  const Pronunciation bee{Phone::B, Phone::IY};
  const std::vector<Pronunciation> options{kBa, kWa};
  EXPECT_THAT(closed_set_probabilities(bee, options, identity_confusions()),
              ElementsAre(DoubleNear(1.0, 1e-5), DoubleNear(0.0, 1e-5)));
}

TEST(ClosedSet, GuessesWhereNoOptionHasTheShapeOfTheStimulus) {
  const std::vector<Pronunciation> options{kBa, kWa, {}, {}};
  EXPECT_THAT(closed_set_probabilities(kStew, options, identity_confusions()),
              ElementsAre(0.25, 0.25, 0.25, 0.25));
}

}  // namespace
}  // namespace bimodal::protocols
