#include "stimuli/timeline/festival_phones.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace bimodal {
namespace {

using enum Phone;

TEST(FestivalPhones, GiveEveryPhoneButWhBack) {
  for (const Phone phone : all_phones()) {
    const Phone heard = phone == WH ? W : phone;
    EXPECT_EQ(phones_from_festival(festival_symbol(phone)), std::vector{heard}) << symbol(phone);
    EXPECT_TRUE(realises(festival_symbol(phone), phone)) << symbol(phone);
  }
}

TEST(FestivalPhones, CoverEverySymbolOfTheRadioSet) {
  for (const auto* const symbol :
       {"aa", "ae", "ah", "ao", "aw", "ax", "axr", "ay", "b",   "ch", "d",   "dh", "dx",
        "eh", "el", "em", "en", "er", "ey", "f",   "g",  "hh",  "hv", "ih",  "iy", "jh",
        "k",  "l",  "m",  "n",  "nx", "ng", "ow",  "oy", "p",   "r",  "s",   "sh", "t",
        "th", "uh", "uw", "v",  "w",  "y",  "z",   "zh", "pau", "h#", "brth"}) {
    EXPECT_FALSE(phones_from_festival(symbol).empty()) << symbol;
  }
  EXPECT_TRUE(phones_from_festival("x").empty());
}

TEST(FestivalPhones, AllowReductionsButNoOtherPhone) {
  EXPECT_TRUE(realises("ax", AH));
  EXPECT_TRUE(realises("dx", D));
  EXPECT_FALSE(realises("ax", T));
  EXPECT_FALSE(realises("dx", N));
  EXPECT_FALSE(realises("ah", AX));
  EXPECT_FALSE(realises("t", D));
}

}  // namespace
}  // namespace bimodal
