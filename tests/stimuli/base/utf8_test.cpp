#include "stimuli/base/utf8.hpp"

#include <gtest/gtest.h>

namespace bimodal {
namespace {

TEST(Utf8, OfEveryCharacterIsWellFormed) {
  for (char32_t character = 1; character <= 0x10FFFFU; ++character) {
    if (character == 0xD800U) character = 0xE000U;  // no surrogates
    std::string text;
    append_utf8(text, character);
    ASSERT_EQ(utf8_length(text, 0), text.size()) << static_cast<std::uint32_t>(character);
  }
}

TEST(Utf8, HasTheBytesThatTheStandardGives) {
  // The Unicode Standard 15, table 3-4.
  std::string text;
  for (const char32_t character : {0x4DU, 0x430U, 0x4E8CU, 0x10302U}) append_utf8(text, character);
  EXPECT_EQ(text, "\x4D\xD0\xB0\xE4\xBA\x8C\xF0\x90\x8C\x82");
}

TEST(Utf8, RefusesIllFormedBytes) {
  for (const auto* const bytes : {"\x80",
                                  "\xC0\xAF",
                                  "\xC3",
                                  "\xC3(",
                                  "\xE0\x9F\x80",
                                  "\xED\xA0\x80",  // a surrogate
                                  "\xF0\x8F\x80\x80",
                                  "\xF4\x90\x80\x80",
                                  "\xF5\x80\x80\x80",
                                  "\xFF"}) {
    EXPECT_FALSE(is_utf8(std::string{"ok"} + bytes));
  }
  EXPECT_TRUE(is_utf8(""));
}

}  // namespace
}  // namespace bimodal
