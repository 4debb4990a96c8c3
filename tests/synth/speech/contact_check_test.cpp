// Closure and contact follow from the inventory's values alone, in every syllable at every rate.
#include "synth/speech/contact_check.hpp"

#include <array>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/digest.hpp"

namespace bimodal::synth {
namespace {

SegmentTable shipped(const std::string& name) {
  return SegmentTable{asset("synth/assets/segments/" + name + ".json")};
}

class Contacts : public testing::TestWithParam<const char*> {};

TEST_P(Contacts, AreMadeInEverySyllableAtEveryRate) {
  const auto report = check_contacts(shipped(GetParam()), std::array{0.5, 0.7, 1.0, 1.4, 2.0});
  EXPECT_EQ(report.contexts, 5 * 16 * 2 * 5 * 25);
  EXPECT_GE(report.briefest, kShownPicture);
  for (const auto& missed : report.missed) {
    ADD_FAILURE() << symbol(missed.phone) << " in " << missed.context << " at rate " << missed.rate
                  << ": " << missed.longest.count() << " ms";
    if (&missed - report.missed.data() > 20) break;
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, Contacts, testing::Values("english", "turkish-plateau"));

TEST(ContactCheck, FindsWhatAnInventoryMisses) {
  auto tree = nlohmann::json::parse(read_file(asset("synth/assets/segments/english.json")));
  tree["groups"]["closure"]["rows"]["P B M"][6] = 1.02;  // hardly beyond contact
  std::vector<Diagnostic> diagnostics;
  const auto table = SegmentTable::parse(tree.dump(), "weak.json", diagnostics);
  ASSERT_TRUE(table);
  const auto report = check_contacts(*table, std::array{2.0});
  EXPECT_FALSE(report.missed.empty());
  EXPECT_LT(report.briefest, kShownPicture);
  for (const auto& missed : report.missed) EXPECT_NE(missed.phone, Phone::F);
}

}  // namespace
}  // namespace bimodal::synth
