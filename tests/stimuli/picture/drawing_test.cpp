#include "stimuli/picture/drawing.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "stimuli/picture/letters.hpp"

namespace bimodal {
namespace {

constexpr Colour kWhite{255, 255, 255};
constexpr Colour kRed{255, 0, 0};

std::size_t count(const Image& image, Colour colour) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    if (Colour{image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]} == colour) ++found;
  }
  return found;
}

TEST(Drawing, FillsWhatIsWithinThePicture) {
  auto image = blank_image(10, 8, kWhite);
  EXPECT_EQ(count(image, kWhite), 80U);
  fill(image, {2, 3}, {4, 2}, kRed);
  EXPECT_EQ(count(image, kRed), 8U);
  fill(image, {-5, -5}, {6, 6}, kRed);
  EXPECT_EQ(count(image, kRed), 9U);
  fill(image, {9, 7}, {100, 100}, kRed);
  EXPECT_EQ(count(image, kRed), 10U);
  fill(image, {20, 20}, {5, 5}, kRed);
  fill(image, {5, 5}, {-3, 2}, kRed);
  EXPECT_EQ(count(image, kRed), 10U);
}

TEST(Drawing, PastesWhatIsWithinThePicture) {
  const auto part = blank_image(4, 4, kRed);
  for (const auto& [place, pixels] : {std::pair{Place{3, 2}, 16U},
                                      {Place{-2, -1}, 6U},
                                      {Place{8, 6}, 4U},
                                      {Place{10, 0}, 0U},
                                      {Place{0, -4}, 0U}}) {
    auto image = blank_image(10, 8, kWhite);
    paste(image, place, part);
    EXPECT_EQ(count(image, kRed), pixels) << place.x << " " << place.y;
  }
}

TEST(Drawing, LettersAreAllDifferentAndFiveBySeven) {
  std::set<std::string> seen;
  for (const char letter : std::string{
           "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-+.,:;'\"()/_?!%= "}) {
    std::string whole;
    for (const auto row : letter_rows(letter)) {
      EXPECT_EQ(row.size(), 5U) << letter;
      whole += row;
    }
    EXPECT_TRUE(seen.insert(whole).second) << letter;
  }
}

TEST(Drawing, TextIsAsWideAsItsCharacters) {
  EXPECT_EQ(text_width("stew", 2), 48);
  EXPECT_EQ(text_width("caf\xC3\xA9"), 24);
  auto image = blank_image(60, 16, kWhite);
  draw_text(image, {0, 0}, "I-", kRed, 2);
  EXPECT_EQ(count(image, kRed), 4U * (11 + 3));
}

}  // namespace
}  // namespace bimodal
