#include "synth/inspection/contact_table.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/digest.hpp"
#include "synth/speech/articulation.hpp"
#include "synth/speech/durations.hpp"
#include "tests/synth/face/the_head.hpp"

namespace bimodal::synth {
namespace {

// One in 1201 of the 29,376 syllables; `bimodal segments contacts` looks at all.
TEST(ContactTable, OfTheEnglishInventoryMeetsEveryRequirement) {
  const SegmentTable table{asset("synth/assets/segments/english.json")};
  const auto contacts = measure_contacts(the_head(), table, {.every = 1201});
  for (const auto& row : contacts.rows) {
    EXPECT_EQ(row.met, row.cases) << row.sounds << ": " << row.requirement << ": " << row.worst
                                  << " in " << row.worst_case;
    EXPECT_GT(row.cases, 0U) << row.sounds;
  }
  EXPECT_LE(contacts.deepest.worst(), 0.2) << contacts.deepest_case;
  EXPECT_EQ(contacts.pictures, 25U * 6U);
}

// Where the teeth open least and the tongue has least time: what the sample above does not hold.
TEST(ContactTable, HoldsForTheTongueBetweenTeethBesideUwInFastSpeech) {
  const SegmentTable table{asset("synth/assets/segments/english.json")};
  const auto fast = [&](const char* sounds) {
    return Articulation{at_rate(typed_segments(sounds), 2.0), table}.sample(Hertz{60});
  };
  MouthRuler ruler{the_head()};
  for (const auto* const sounds : {"ZH UW DH", "P UW DH", "WH UW TH"}) {
    double most = 0;
    for (const auto& pose : fast(sounds)) {
      most = std::max(most, ruler.measure(pose).seen.tongue_between_teeth_mm2);
    }
    EXPECT_GE(most, 4) << sounds;
  }
}

TEST(ContactTable, FindsLipsThatDoNotShut) {
  auto text = read_file(asset("synth/assets/segments/english.json"));
  const std::string shipped = "1.8, 0.7]";
  const auto place = text.find(shipped);
  ASSERT_NE(place, std::string::npos);
  text.replace(place, shipped.size(), "0.5, 0.7]");
  std::vector<Diagnostic> diagnostics;
  const auto table = SegmentTable::parse(text, "open.json", diagnostics);
  ASSERT_TRUE(table);
  const auto contacts = measure_contacts(the_head(), *table, {.rates = {1.0}, .every = 977});
  EXPECT_LT(contacts.rows.front().met, contacts.rows.front().cases);
  EXPECT_GT(contacts.rows.front().worst, 0.05);
}

}  // namespace
}  // namespace bimodal::synth
