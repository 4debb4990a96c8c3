#include "runner/devices/simulated/simulated_input.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/devices/simulated/virtual_clock.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(SimulatedInput, HearsTheRoomFirstAndThenOneUtteranceACapture) {
  VirtualClock clock;
  SimulatedInput input{
      clock,
      {.rate = Hertz{1'000}, .room = {0.1F, 0.2F}, .utterances = {{1, 2}, {3}}, .reaction = 2ms}};
  const auto capture = [&] {
    std::vector<float> samples;
    input.start();
    clock.advance_by(3ms);
    input.collect(samples);
    clock.advance_by(3ms);
    input.collect(samples);
    input.stop();
    clock.advance_by(3ms);
    input.collect(samples);
    return samples;
  };
  EXPECT_THAT(capture(), ElementsAre(0.1F, 0.2F, 0.1F, 0.2F, 0.1F, 0.2F));
  EXPECT_THAT(capture(), ElementsAre(0.1F, 0.2F, 1.0F, 2.0F, 0.1F, 0.2F));
  EXPECT_THAT(capture(), ElementsAre(0.1F, 0.2F, 3.0F, 0.2F, 0.1F, 0.2F));
  EXPECT_THAT(capture(), ElementsAre(0.1F, 0.2F, 1.0F, 2.0F, 0.1F, 0.2F));
  EXPECT_EQ(input.lost(), 0);
}

TEST(SimulatedInput, IsSilentWithoutARoomAndATalker) {
  VirtualClock clock;
  SimulatedInput input{clock, {.rate = Hertz{1'000}}};
  std::vector<float> samples;
  input.collect(samples);
  EXPECT_THAT(samples, IsEmpty());
  input.start();
  clock.advance_by(2ms);
  input.collect(samples);
  EXPECT_THAT(samples, ElementsAre(0.0F, 0.0F));
}

}  // namespace
}  // namespace bimodal::runner
