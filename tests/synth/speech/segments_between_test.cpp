// What lies between two segments.
#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::synth {
namespace {

using enum Phone;

std::filesystem::path english() {
  return asset("synth/assets/segments/english.json");
}

TEST(Between, IsEachEndAtItsEndAndInProportionOnTheWay) {
  const SegmentTable table{english()};
  for (const auto& control : controls().first<kSpeechControlCount>()) {
    const auto& b = table.at(B, control.control);
    const auto& w = table.at(W, control.control);
    EXPECT_EQ(table.at(Segment{B, W, 0, 8}, control.control).dominance, b.dominance);
    EXPECT_EQ(table.at(Segment{B, W, 8, 8}, control.control).target, w.target);
    const auto part = table.at(Segment{B, W, 3, 8}, control.control);
    const bool is_limited = control.control == Control::LipClosure;  // the contact they differ in
    const double first = is_limited ? 1 : b.target;
    const double last = is_limited ? 0 : w.target;
    EXPECT_NEAR(part.target, first + 0.375 * (last - first), 1e-12);
    EXPECT_NEAR(part.dominance.alpha,
                b.dominance.alpha + 0.375 * (w.dominance.alpha - b.dominance.alpha),
                1e-12);
    EXPECT_NEAR(part.offset.count(),
                b.offset.count() + 0.375 * (w.offset.count() - b.offset.count()),
                1e-12);
  }
}

TEST(Between, KeepsWhatBothPhonesAsk) {
  const SegmentTable table{english()};
  for (const auto& control : controls().first<kSpeechControlCount>()) {
    const auto& s = table.at(S, control.control);
    const auto& sh = table.at(SH, control.control);
    if (s.target != sh.target) continue;
    EXPECT_EQ(table.at(Segment{S, SH, 1, 4}, control.control).target, s.target) << control.name;
  }
}

TEST(Between, GivesASegmentWithoutInflectionTheOthersPlaceWithItsOwnTheta) {
  SegmentTarget plain{.dominance = {.theta_before = 0.02, .theta_after = 0.02}};
  SegmentTarget inflected{
      .dominance = {
          .theta_before = 0.04, .theta_after = 0.02, .inflection_ms = 68, .theta_early = 0.01}};
  const auto half = between(plain, inflected, 0.5).dominance;
  EXPECT_DOUBLE_EQ(half.inflection_ms, 68);
  EXPECT_DOUBLE_EQ(half.theta_early, 0.015);
  EXPECT_DOUBLE_EQ(half.theta_before, 0.03);
}

}  // namespace
}  // namespace bimodal::synth
