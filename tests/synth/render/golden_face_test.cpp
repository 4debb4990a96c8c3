// Pictures of the face against those that were looked at and kept in tests/golden/face.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/synth/render/drawn_head.hpp"

namespace bimodal::synth {
namespace {

using enum Control;

// Other processors and versions of llvmpipe round otherwise, and edges fall to the neighbouring
// pixel; a lip or a tooth that has moved by a millimetre differs by more than either bound.
constexpr double kMostOnAverage = 1.0;  // of 255, mean over all pixels and colours
constexpr int kMostOf99Percent = 10;    // of 255, for 99 of 100 values

struct Difference {
  double mean = 0.0;
  int of_99_percent = 0;
};

Difference difference(const Image& one, const Image& other) {
  std::vector<int> levels;
  double sum = 0.0;
  for (std::size_t i = 0; i < one.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    levels.push_back(std::abs(int{one.pixels[i]} - int{other.pixels[i]}));
    sum += levels.back();
  }
  const auto at_99 = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() * 99 / 100);
  std::ranges::nth_element(levels, at_99);
  return {sum / static_cast<double>(levels.size()), *at_99};
}

class GoldenFace : public Drawing {
 protected:
  static void expect_as_kept(std::string_view name,
                             const Pose& pose,
                             const View& view,
                             const Appearance& appearance) {
    HeadRenderer renderer{the_head(), view, appearance};
    if (renderer.description().find("llvmpipe") == std::string::npos) {
      GTEST_SKIP() << "the pictures are llvmpipe's: other drivers mix colours and cover edges "
                      "otherwise; here it is "
                   << renderer.description();
    }
    Image image;
    renderer.draw(pose, image);
    const auto folder = std::filesystem::path{BIMODAL_TEST_ROOT} / "golden" / "face";
    const auto kept = folder / (std::string{name} + ".png");
    if (const char* wanted = std::getenv("BIMODAL_GOLDEN");
        wanted != nullptr && std::string_view{wanted} == "write") {
      write_png(image, kept);
      GTEST_SKIP() << kept << " was written anew; look at it before you keep it";
    }
    const auto found = difference(image, read_png(kept));
    EXPECT_TRUE(found.mean <= kMostOnAverage && found.of_99_percent <= kMostOf99Percent)
        << kept << ": differs by " << found.mean << " on average (at most " << kMostOnAverage
        << "), 99 of 100 values by up to " << found.of_99_percent << " (at most "
        << kMostOf99Percent
        << "). If the face was meant to change: BIMODAL_GOLDEN=write build/tests/synth_tests "
           "--gtest_filter='GoldenFace*', and look at the pictures";
  }

  static View small(double yaw_deg = 0.0) {
    return {.width = 160, .height = 180, .yaw_deg = yaw_deg};
  }

  static View mouth() {
    return {.width = 160, .height = 180, .centre_y_mm = -76.0, .field_mm = 100.0};
  }

  static Pose open_mouth() {
    return pose_of({{Jaw, 9.0}, {UpperLipRaise, 2.0}, {LipWidth, 3.0}, {TongueTip, 6.0}});
  }
};

TEST_F(GoldenFace, AtRestIsAsKept) {
  expect_as_kept("neutral", neutral_pose(), small(), {});
}

TEST_F(GoldenFace, WithTheLipTuckedForFIsAsKept) {
  const Pose f = pose_of({{Jaw, 3.0}, {LowerLipTuck, 1.0}, {UpperLipRaise, 1.5}});
  expect_as_kept("f", f, mouth(), {});
}

TEST_F(GoldenFace, WithTeethAndTongueInTheOpenMouthIsAsKept) {
  expect_as_kept("open", open_mouth(), mouth(), {});
}

TEST_F(GoldenFace, InFullQualityIsAsKept) {
  Appearance full;
  full.quality = Quality::Full;
  expect_as_kept("full", open_mouth(), small(38.0), full);
}

TEST_F(GoldenFace, WithTransparentSkinFromTheSideIsAsKept) {
  Appearance ghost;
  ghost.skin_transparency = 0.6;
  expect_as_kept("transparent", open_mouth(), small(90.0), ghost);
}

TEST_F(GoldenFace, CutInTheMiddleIsAsKept) {
  Appearance half;
  half.cut = Plane{.normal = {1.0, 0.0, 0.0}, .distance_mm = 0.0};
  expect_as_kept("section", open_mouth(), small(90.0), half);
}

}  // namespace
}  // namespace bimodal::synth
