#include "analysis/scoring/phone_features.hpp"

#include <gtest/gtest.h>

namespace bimodal::analysis {
namespace {

TEST(FeatureDifference, IsTheShareOfFeaturesThatDifferByHand) {
  EXPECT_EQ(feature_difference(Phone::P, Phone::P), 0);
  EXPECT_EQ(feature_difference(Phone::P, Phone::B), 5);    // voicing
  EXPECT_EQ(feature_difference(Phone::P, Phone::T), 5);    // place
  EXPECT_EQ(feature_difference(Phone::B, Phone::M), 5);    // manner
  EXPECT_EQ(feature_difference(Phone::P, Phone::M), 10);   // voicing and manner
  EXPECT_EQ(feature_difference(Phone::P, Phone::ZH), 15);  // all three
  EXPECT_EQ(feature_difference(Phone::IY, Phone::IH), 3);  // length
  EXPECT_EQ(feature_difference(Phone::IY, Phone::UW), 6);  // backness and rounding
  EXPECT_EQ(feature_difference(Phone::AA, Phone::AY), 3);  // glide
  EXPECT_EQ(feature_difference(Phone::AE, Phone::OW), 15);
}

TEST(FeatureDifference, IsSymmetricAndAtMostOne) {
  for (const Phone one : all_phones()) {
    for (const Phone other : all_phones()) {
      if (one == Phone::Rest || other == Phone::Rest || is_vowel(one) != is_vowel(other)) continue;
      EXPECT_EQ(feature_difference(one, other), feature_difference(other, one));
      EXPECT_LE(feature_difference(one, other), kAllFeatures);
      EXPECT_EQ(feature_difference(one, other) == 0, one == other);
    }
  }
}

TEST(Place, RunsFromTheLipsToTheGlottisInTheOrderOfPhones) {
  for (std::size_t i = 2; i < all_phones().size(); ++i) {
    const Phone phone = all_phones()[i];
    if (!is_consonant(phone)) continue;
    EXPECT_LE(consonant_features(all_phones()[i - 1]).place, consonant_features(phone).place);
  }
}

}  // namespace
}  // namespace bimodal::analysis
