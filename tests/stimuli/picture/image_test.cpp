#include "stimuli/picture/image.hpp"

#include <array>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"

namespace bimodal {
namespace {

using testing::HasSubstr;

class PictureFile : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }

  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path file(const char* name) const { return folder_ / name; }

  [[nodiscard]] std::filesystem::path file_of(const char* name, const std::string& bytes) const {
    std::ofstream{file(name), std::ios::binary} << bytes;
    return file(name);
  }

  static std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
  }

  static std::string refusal(const std::filesystem::path& file) {
    try {
      static_cast<void>(read_png(file));
    } catch (const Error& error) {
      return error.what();
    }
    return "no refusal";
  }

 private:
  std::filesystem::path folder_ = std::filesystem::path{testing::TempDir()} /
                                  testing::UnitTest::GetInstance()->current_test_info()->name();
};

/// Every pixel different from its neighbours; opaque.
Image pattern(std::size_t width, std::size_t height) {
  Image image{width, height, std::vector<std::uint8_t>(width * height * 4)};
  for (std::size_t i = 0; i < width * height; ++i) {
    image.pixels[4 * i] = static_cast<std::uint8_t>(i * 7);
    image.pixels[4 * i + 1] = static_cast<std::uint8_t>(i / width);
    image.pixels[4 * i + 2] = static_cast<std::uint8_t>(i >> 8U);
    image.pixels[4 * i + 3] = 255;
  }
  return image;
}

TEST_F(PictureFile, ComesBackAsItWasWritten) {
  const Image image = pattern(641, 357);
  write_png(image, file("pattern.png"));
  const Image back = read_png(file("pattern.png"));
  EXPECT_EQ(back.width, 641U);
  EXPECT_EQ(back.height, 357U);
  EXPECT_EQ(back.pixels, image.pixels);
}

TEST_F(PictureFile, HasItsFirstRowOnTop) {
  // Made with Python's zlib and struct: 1 x 2 pixels, RGB, a red pixel above a blue one.
  constexpr std::array<unsigned char, 70> kRedAboveBlue{
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
      0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x02, 0x08, 0x02, 0x00, 0x00,
      0x00, 0x16, 0xe3, 0x21, 0x70, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x44, 0x41, 0x54, 0x78,
      0x9c, 0x63, 0xf8, 0xcf, 0x00, 0x02, 0xff, 0x01, 0x08, 0x00, 0x01, 0xff, 0xd9, 0x90,
      0xbb, 0x35, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  const Image image =
      read_png(file_of("two.png", std::string{kRedAboveBlue.begin(), kRedAboveBlue.end()}));
  ASSERT_EQ(image.width, 1U);
  ASSERT_EQ(image.height, 2U);
  EXPECT_EQ(image.pixels, (std::vector<std::uint8_t>{255, 0, 0, 255, 0, 0, 255, 255}));
}

TEST_F(PictureFile, IsRefusedByNameIfMissing) {
  EXPECT_THAT(refusal(file("nowhere.png")), HasSubstr("nowhere.png"));
}

TEST_F(PictureFile, IsRefusedByNameIfItIsNoPng) {
  EXPECT_THAT(refusal(file_of("words.png", "not a picture")), HasSubstr("words.png"));
}

TEST_F(PictureFile, IsRefusedByNameIfCutShort) {
  write_png(pattern(100, 100), file("whole.png"));
  const std::string bytes = bytes_of(file("whole.png"));
  EXPECT_THAT(refusal(file_of("cut.png", bytes.substr(0, bytes.size() / 2))), HasSubstr("cut.png"));
}

TEST_F(PictureFile, IsRefusedByNameIfDamaged) {
  write_png(pattern(100, 100), file("whole.png"));
  std::string bytes = bytes_of(file("whole.png"));
  bytes.at(bytes.size() / 2) = static_cast<char>(~bytes.at(bytes.size() / 2));
  EXPECT_THAT(refusal(file_of("damaged.png", bytes)), HasSubstr("damaged.png"));
}

TEST_F(PictureFile, IsRefusedIfPartlyTransparent) {
  Image image = pattern(4, 4);
  image.pixels[7] = 128;
  write_png(image, file("glass.png"));
  EXPECT_THAT(refusal(file("glass.png")), HasSubstr("without an alpha channel"));
}

TEST_F(PictureFile, ThatCannotBeWrittenIsNamed) {
  try {
    write_png(pattern(2, 2), file("a.jpg"));
    FAIL() << "a name that does not end with .png was taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string_view{error.what()}.find("end the name with .png"),
              std::string_view::npos);
  }
  try {
    write_png(pattern(2, 2), file("no_such_folder") / "a.png");
    FAIL() << "written into a folder that does not exist";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.png"));
  }
}

}  // namespace
}  // namespace bimodal
