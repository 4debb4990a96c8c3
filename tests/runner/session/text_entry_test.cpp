#include "runner/session/text_entry.hpp"

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal::runner {
namespace {

TEST(TextEntry, ErasesWholeCodePoints) {
  TextEntry entry{40};
  entry.type("na\xc3\xafve");  // "naive" with a diaeresis
  entry.erase();
  entry.erase();
  entry.erase();
  EXPECT_EQ(entry.text(), "na");
}

TEST(TextEntry, ErasingNothingIsHarmless) {
  TextEntry entry{40};
  entry.erase();
  EXPECT_EQ(entry.text(), "");
}

TEST(TextEntry, CountsCodePointsNotBytes) {
  TextEntry entry{3};
  entry.type("\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac");  // four euro signs
  EXPECT_EQ(entry.text(), "\xe2\x82\xac\xe2\x82\xac\xe2\x82\xac");
}

TEST(TextEntry, RefusesControlCharactersAndMalformedBytes) {
  TextEntry entry{40};
  entry.type(std::string_view{"a\tb\x7f\xff\xc0\x80\xed\xa0\x80\xf5z\xc3", 14});
  EXPECT_EQ(entry.text(), "abz");
}

TEST(TextEntryProperty, RandomBytesAndErasuresLeaveTextThatErasesToNothing) {
  Random random{20'261'121};
  for (int round = 0; round < 500; ++round) {
    TextEntry entry{20};
    for (int step = 0; step < 30; ++step) {
      std::string bytes;
      for (std::uint64_t i = random.below(6); i > 0; --i) {
        bytes += static_cast<char>(random.below(256));
      }
      entry.type(bytes);
      if (random.below(3) == 0) entry.erase();
    }
    for (int i = 0; i < 20; ++i) entry.erase();
    ASSERT_EQ(entry.text(), "");
  }
}

}  // namespace
}  // namespace bimodal::runner
