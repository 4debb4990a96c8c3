// How the pictures that FrameReader hands out look: colour, shape, rotation, interlacing.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/video/frame_reader.hpp"
#include "tests/stimuli/video/made_media.hpp"

namespace bimodal {
namespace {

using made_media::message_of;
using ::testing::HasSubstr;

using Colour = std::array<int, 3>;

Colour pixel(const Image& image, std::size_t x, std::size_t y) {
  const auto* at = image.pixels.data() + (y * image.width + x) * 4;
  EXPECT_EQ(at[3], 255);
  return {at[0], at[1], at[2]};
}

Image first_image(const std::filesystem::path& file, std::size_t height = 0) {
  FrameReader reader{file, {.height = height, .span = {}}};
  auto frame = reader.next();
  EXPECT_TRUE(frame);
  EXPECT_EQ(frame->image.width, reader.width());
  EXPECT_EQ(frame->image.height, reader.height());
  return frame ? frame->image : Image{};
}

void expect_near(const Colour& found, const Colour& expected, int tolerance) {
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found.at(i), expected.at(i), tolerance)
        << "found " << found[0] << ' ' << found[1] << ' ' << found[2] << ", expected "
        << expected[0] << ' ' << expected[1] << ' ' << expected[2];
  }
}

/// ITU-T H.273, equations for matrix coefficients of kr and kb.
Colour from_components(double y, double cb, double cr, double kr, double kb, bool full) {
  const double luma = full ? y / 255.0 : (y - 16.0) / 219.0;
  const double blue = (cb - 128.0) / (full ? 255.0 : 224.0);
  const double red = (cr - 128.0) / (full ? 255.0 : 224.0);
  const double r = luma + 2.0 * (1.0 - kr) * red;
  const double b = luma + 2.0 * (1.0 - kb) * blue;
  const double g = (luma - kr * r - kb * b) / (1.0 - kr - kb);
  const auto byte = [](double value) {
    return static_cast<int>(std::lround(std::clamp(value, 0.0, 1.0) * 255.0));
  };
  return {byte(r), byte(g), byte(b)};
}

class Picture : public made_media::MadeMedia {};

struct Matrix {
  std::string name;
  std::string size;
  std::string tags;
  double kr;
  double kb;
  bool full;
};

std::ostream& operator<<(std::ostream& out, const Matrix& matrix) {
  return out << matrix.name;
}

class EveryMatrix : public Picture, public ::testing::WithParamInterface<Matrix> {};

TEST_P(EveryMatrix, GivesTheColoursOfItsDefinition) {
  const auto& matrix = GetParam();
  for (const auto& [y, cb, cr] : {Colour{100, 110, 170}, {60, 160, 100}, {180, 90, 120}}) {
    const auto file = made("a.mkv",
                           "-f lavfi -i \"nullsrc=s=" + matrix.size +
                               ":r=25:d=0.08,format=yuv444p,geq=lum=" + std::to_string(y) +
                               ":cb=" + std::to_string(cb) + ":cr=" + std::to_string(cr) +
                               "\" -c:v ffv1 " + matrix.tags);
    expect_near(pixel(first_image(file), 20, 20),
                from_components(y, cb, cr, matrix.kr, matrix.kb, matrix.full),
                1);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of,
    EveryMatrix,
    ::testing::Values(Matrix{"UntaggedSmall", "360x288", "", 0.299, 0.114, false},
                      Matrix{"UntaggedLarge", "1280x720", "", 0.2126, 0.0722, false},
                      Matrix{"Bt601", "1280x720", "-colorspace smpte170m", 0.299, 0.114, false},
                      Matrix{"Bt709", "360x288", "-colorspace bt709", 0.2126, 0.0722, false},
                      Matrix{"Bt2020", "360x288", "-colorspace bt2020nc", 0.2627, 0.0593, false},
                      Matrix{"Bt709OfFullRange",
                             "360x288",
                             "-colorspace bt709 -color_range pc",
                             0.2126,
                             0.0722,
                             true}),
    [](const auto& each) { return each.param.name; });

class EveryPixelFormat : public Picture, public ::testing::WithParamInterface<const char*> {};

TEST_P(EveryPixelFormat, BringsPlainColoursBack) {
  const std::string format = GetParam();
  const std::string codec = format == "pal8"       ? "png"
                            : format == "yuvj420p" ? "mjpeg -q:v 1"
                                                   : "rawvideo";
  // Made larger, then cut to an odd size: the last column would else be FFmpeg's guess.
  const auto filter = format == "pal8"
                          ? ",split[a][b];[a]palettegen=reserve_transparent=0[p];[b][p]paletteuse"
                          : ",format=" + format + ",crop=321:241:0:0:exact=1";
  for (const auto& [hex, colour] : {std::pair{"C86432", Colour{200, 100, 50}},
                                    {"2040C0", Colour{32, 64, 192}},
                                    {"808080", Colour{128, 128, 128}}}) {
    const bool grey = format.starts_with("gray");
    if (grey && colour[0] != colour[2]) continue;
    const auto* size = format == "pal8" ? "321x241" : "322x242";
    const auto file =
        made("a.nut",
             std::string{"-f lavfi -i \"color=0x"} + hex + ":s=" + size +
                 ":r=25:d=0.12,format=rgb24" + filter + "\" -pix_fmt " + format + " -c:v " + codec);
    const auto image = first_image(file);
    EXPECT_EQ(image.width, 321U);
    EXPECT_EQ(image.height, 241U);
    for (const auto& [x, y] :
         {std::pair{0U, 0U}, {320U, 0U}, {160U, 120U}, {0U, 240U}, {320U, 240U}}) {
      expect_near(pixel(image, x, y), colour, 3);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of,
                         EveryPixelFormat,
                         ::testing::Values("yuv420p",
                                           "yuv422p",
                                           "yuv444p",
                                           "yuv420p10le",
                                           "yuv444p12le",
                                           "yuvj420p",
                                           "yuva420p",
                                           "nv12",
                                           "gray",
                                           "gray10le",
                                           "pal8",
                                           "rgb24",
                                           "bgra",
                                           "gbrp",
                                           "gbrp10le",
                                           "rgb48le"),
                         [](const auto& each) { return std::string{each.param}; });

/// Red, green, blue, white in the quarters: upper left, upper right, lower left, lower right.
constexpr auto kQuarters =
    "-f lavfi -i \"nullsrc=s=128x96:r=25:d=0.2,format=rgb24,"
    "geq=r='255*(lt(X,64)*lt(Y,48)+gte(X,64)*gte(Y,48))'"
    ":g='255*gte(X,64)':b='255*gte(Y,48)'\" -pix_fmt yuv444p -c:v libx264 -qp 0 ";

TEST_F(Picture, IsTurnedUpright) {
  const Colour red{255, 0, 0};
  const Colour green{0, 255, 0};
  const Colour blue{0, 0, 255};
  const Colour white{255, 255, 255};
  const auto stored = made("a.mp4", kQuarters);

  struct Turn {
    int tag;
    std::array<Colour, 4> quarters;
  };

  for (const auto& [tag, quarters] : {Turn{0, {red, green, blue, white}},
                                      Turn{90, {blue, red, white, green}},
                                      Turn{180, {white, blue, green, red}},
                                      Turn{270, {green, white, red, blue}}}) {
    // FFmpeg 5.1 takes the tag for degrees anticlockwise.
    const auto file = made("b.mp4",
                           "-i '" + stored.string() + "' -c copy -metadata:s:v rotate=" +
                               std::to_string((360 - tag) % 360));
    const auto media = examine_media(file);
    EXPECT_EQ(media.picture->rotation_degrees, tag);
    const auto image = first_image(file);
    EXPECT_EQ(image.width, tag % 180 == 0 ? 128U : 96U);
    EXPECT_EQ(image.height, tag % 180 == 0 ? 96U : 128U);
    EXPECT_EQ(media.picture->width, image.width);
    EXPECT_EQ(media.picture->height, image.height);
    const auto left = image.width / 4;
    const auto top = image.height / 4;
    expect_near(pixel(image, left, top), quarters[0], 6);
    expect_near(pixel(image, 3 * left, top), quarters[1], 6);
    expect_near(pixel(image, left, 3 * top), quarters[2], 6);
    expect_near(pixel(image, 3 * left, 3 * top), quarters[3], 6);
    // What the ffmpeg program shows, which turns by itself.
    const auto shown = made("c.png", "-i '" + file.string() + "' -frames:v 1 -pix_fmt rgb24");
    const auto theirs = read_png(shown);
    ASSERT_EQ(theirs.width, image.width);
    expect_near(pixel(image, left, top), pixel(theirs, left, top), 6);
    expect_near(pixel(image, 3 * left, 3 * top), pixel(theirs, 3 * left, 3 * top), 6);
  }
}

TEST_F(Picture, HasSquarePixelsAndTheHeightAskedFor) {
  const auto file =
      made("a.mkv", "-f lavfi -i color=red:s=720x576:r=25:d=0.2 -vf setsar=16/15 -c:v ffv1");
  const auto media = examine_media(file);
  EXPECT_EQ(media.picture->width, 768U);
  EXPECT_EQ(media.picture->height, 576U);
  EXPECT_EQ(media.picture->stored_width, 720U);
  EXPECT_EQ(first_image(file).width, 768U);
  const auto higher = first_image(file, 720);
  EXPECT_EQ(higher.width, 960U);
  EXPECT_EQ(higher.height, 720U);
  expect_near(pixel(higher, 959, 719), {254, 0, 0}, 3);
  const auto narrow =
      made("b.mkv", "-f lavfi -i color=red:s=640x480:r=25:d=0.2 -vf setsar=1/2 -c:v ffv1");
  EXPECT_EQ(first_image(narrow).width, 320U);
  EXPECT_THAT(message_of([&] {
                FrameReader{file, {.height = 100'000, .span = {}}};
              }),
              HasSubstr("choose a smaller height"));
}

TEST_F(Picture, IsDeinterlaced) {
  // A white bar moves by 4 pixels a field: stored interlaced, its edges are combs.
  const std::string fields =
      "-f lavfi -i \"nullsrc=s=320x64:r=50:d=1,"
      "geq=lum='if(between(X,40+4*N,100+4*N),235,16)':cb=128:cr=128,format=yuv420p,"
      "interlace=scan=tff:lowpass=0\" ";
  const auto file =
      made("a.mpg", fields + "-c:v mpeg2video -flags +ildct+ilme -top 1 -q:v 2 -bf 0");
  EXPECT_TRUE(examine_media(file).picture->interlaced);
  // Lines that differ from both neighbours, which are alike: the teeth of a comb.
  const auto teeth = [](const Image& image) {
    int found = 0;
    for (std::size_t y = 11; y + 11 < image.height; ++y) {
      for (std::size_t x = 0; x < image.width; ++x) {
        const int above = pixel(image, x, y - 1)[0];
        const int here = pixel(image, x, y)[0];
        const int below = pixel(image, x, y + 1)[0];
        if (std::abs(above - below) < 40 && std::abs(here - above) > 120) ++found;
      }
    }
    return found;
  };
  FrameReader reader{file, {}};
  int frames = 0;
  while (const auto frame = reader.next()) {
    EXPECT_EQ(frame->index, frames);
    if (frames > 0 && frames < 24) {
      EXPECT_LT(teeth(frame->image), 20) << frames;
    }
    ++frames;
  }
  EXPECT_EQ(frames, 25);
  // The same picture when reading begins in the middle: the filter has looked back.
  FrameReader again{file, {.height = 0, .span = {.start = std::chrono::milliseconds{410}}}};
  FrameReader whole{file, {}};
  auto expected = whole.next();
  while (expected && expected->index < 10) expected = whole.next();
  const auto found = again.next();
  ASSERT_TRUE(found && expected);
  EXPECT_EQ(found->index, 10);
  EXPECT_EQ(found->image.pixels, expected->image.pixels);
}

TEST_F(Picture, IsRefusedWhenItsSizeChangesOrItIsOfHighDynamicRange) {
  const auto small = made("a.m2v", "-f lavfi -i testsrc=s=64x48:r=25:d=0.4 -c:v mpeg2video");
  const auto large = made("b.m2v", "-f lavfi -i testsrc=s=96x48:r=25:d=0.4 -c:v mpeg2video");
  const auto both = path("both.m2v");
  (void)made_media::printed("cat '" + small.string() + "' '" + large.string() + "' > '" +
                            both.string() + "'");
  EXPECT_THAT(message_of([&] {
                FrameReader reader{both, {}};
                while (reader.next()) {
                }
              }),
              HasSubstr("its picture changes from 64 x 48 to 96 x 48"));
  const auto bright = made("c.mkv",
                           "-f lavfi -i color=red:s=64x48:r=25:d=0.2 -pix_fmt yuv420p10le "
                           "-color_trc smpte2084 -c:v ffv1");
  EXPECT_THAT(message_of([&] { (void)first_image(bright); }), HasSubstr("high dynamic range"));
}

}  // namespace
}  // namespace bimodal
