#include "synth/render/appearance.hpp"

#include <cstdlib>

#include <gmock/gmock.h>

#include "tests/synth/render/drawn_head.hpp"

namespace bimodal::synth {
namespace {

using enum Control;

constexpr Colour kGreen{0, 255, 0};

class DrawnAppearance : public Drawing {
 protected:
  /// Round the mouth.
  static View close_view(double yaw_deg = 0.0) {
    return {.width = 160,
            .height = 160,
            .yaw_deg = yaw_deg,
            .centre_y_mm = -80.0,
            .field_mm = 110.0,
            .backdrop = Backdrop{kGreen, kGreen},
            .centre_z_mm = 70.0};
  }

  static Pose shut_lips() { return pose_of({{Jaw, 2.0}, {LipClosure, 1.0}}); }

  static Pose open_mouth() { return pose_of({{Jaw, 9.0}, {UpperLipRaise, 2.0}}); }

  static Appearance only(std::string_view name) {
    Appearance appearance;
    appearance.shown = *parts_named(name);
    return appearance;
  }

  static Appearance without(std::string_view name) {
    Appearance appearance;
    appearance.shown &= ~*parts_named(name);
    return appearance;
  }
};

TEST_F(DrawnAppearance, OfNothingAskedForIsTheNaturalOne) {
  Appearance natural;
  natural.materials = Materials::named("natural");
  EXPECT_EQ(drawn(open_mouth(), close_view(), natural).pixels,
            drawn(open_mouth(), close_view(), {}).pixels);
}

TEST_F(DrawnAppearance, OfLipsOnlyLeavesTheRestToTheBackdrop) {
  const Image lips = drawn(open_mouth(), close_view(), only("lips"));
  const int backdrop = count_of(lips, kGreen);
  EXPECT_GT(backdrop, 160 * 160 * 70 / 100);
  EXPECT_LT(backdrop, 160 * 160 * 95 / 100);
}

TEST_F(DrawnAppearance, LeavesOutEveryNamedPartWhereItWasSeen) {
  const Pose tongue_out = pose_of({{Jaw, 9.0}, {TongueLength, 12.0}});
  const Image whole = drawn(tongue_out, close_view(), {});
  for (const auto* const name : {"skin", "lips", "teeth", "lower_teeth", "upper_teeth", "tongue"}) {
    EXPECT_GT(count_differing(whole, drawn(tongue_out, close_view(), without(name)), 8), 20)
        << name;
  }
}

TEST_F(DrawnAppearance, WithoutBrowsAndHairLeavesBareSkin) {
  const View whole_head{.width = 160, .height = 180, .backdrop = Backdrop{kGreen, kGreen}};
  Appearance bald = without("hair");
  bald.shown &= ~*parts_named("brows");
  const Image hairy = drawn(neutral_pose(), whole_head, {});
  const Image bare = drawn(neutral_pose(), whole_head, bald);
  EXPECT_GT(count_differing(hairy, bare, 30), 500);
  EXPECT_NEAR(count_of(hairy, kGreen), count_of(bare, kGreen), 60) << "a hole in the skin";
}

TEST_F(DrawnAppearance, OfTransparentSkinShowsTheTongueBehindTheCheek) {
  Appearance ghost;
  ghost.skin_transparency = 0.7;
  Pose raised = shut_lips();
  value(raised, TongueBack) = 15.0;
  for (const double yaw : {38.0, 90.0}) {
    const View view = close_view(yaw);
    EXPECT_EQ(count_differing(drawn(shut_lips(), view, {}), drawn(raised, view, {})), 0) << yaw;
    EXPECT_GT(count_differing(drawn(shut_lips(), view, ghost), drawn(raised, view, ghost), 10), 80)
        << yaw;
  }
}

TEST_F(DrawnAppearance, OfTransparentSkinMixesItsNearestLayerOnly) {
  Appearance ghost;
  ghost.skin_transparency = 0.5;
  ghost.shown &= ~(*parts_named("teeth") | *parts_named("gums") | *parts_named("tongue"));
  const Image opaque = drawn(shut_lips(), close_view(), {});
  const Image mixed = drawn(shut_lips(), close_view(), ghost);
  // In linear light, half the green of the backdrop and half of the skin.
  const std::size_t cheek = 20 * 160 + 20;
  const auto linear = [](int value) { return std::pow(value / 255.0, 2.2); };
  EXPECT_NEAR(linear(pixel(mixed, cheek)[0]), 0.5 * linear(pixel(opaque, cheek)[0]), 0.02);
  EXPECT_NEAR(linear(pixel(mixed, cheek)[1]), 0.5 + 0.5 * linear(pixel(opaque, cheek)[1]), 0.02);
}

TEST_F(DrawnAppearance, OfASectionShowsSkinAndTongueCutInTheirOwnColours) {
  Appearance half;
  half.cut = Plane{.normal = {1.0, 0.0, 0.0}, .distance_mm = 0.0};
  const Image section = drawn(open_mouth(), close_view(90.0), half);
  EXPECT_GT(count_of(section, half.materials.cut_skin), 160 * 160 / 5);
  EXPECT_GT(count_of(section, half.materials.cut_tongue), 160 * 160 / 40);
  EXPECT_GT(count_of(section, half.materials.cut_gums), 20);
}

TEST_F(DrawnAppearance, OfASectionThroughAnIncisorShowsItCut) {
  Appearance cut;
  cut.cut = Plane{.normal = {1.0, 0.0, 0.0}, .distance_mm = 4.0};
  const Image section = drawn(open_mouth(), close_view(90.0), cut);
  EXPECT_GT(count_of(section, cut.materials.cut_teeth), 15);
}

TEST_F(DrawnAppearance, MayBeShadedInThreeWays) {
  Appearance gouraud;
  gouraud.shading = Shading::Gouraud;
  Appearance flat;
  flat.shading = Shading::Flat;
  const Image smooth = drawn(open_mouth(), close_view(38.0), {});
  const Image vertices = drawn(open_mouth(), close_view(38.0), gouraud);
  const Image facets = drawn(open_mouth(), close_view(38.0), flat);
  EXPECT_GT(count_differing(smooth, vertices, 1), 300);
  EXPECT_GT(count_differing(smooth, facets, 4), 300);
  EXPECT_LT(count_differing(smooth, vertices, 40), 160 * 160 / 50) << "another face";
}

TEST_F(DrawnAppearance, OfPointsIsDarkButForTheSpots) {
  Appearance spots;
  spots.materials = Materials::named("point-light");
  for (const auto& [points, fewest, most] :
       {std::tuple{Points::Sparse, 50, 2000}, {Points::Lips, 300, 6000}}) {
    spots.points = points;
    View view = close_view();
    view.backdrop.reset();
    const Image image = drawn(open_mouth(), view, spots);
    const int dark = count_of(image, {0, 0, 0});
    EXPECT_GT(160 * 160 - dark, fewest);
    EXPECT_LT(160 * 160 - dark, most);
  }
}

// The head hides the points behind it, and else is as if it were not there.
TEST_F(DrawnAppearance, OfPointsStandsOnABackdropOfAnyColour) {
  Appearance spots;
  spots.materials = Materials::named("point-light");
  spots.points = Points::Sparse;
  const Colour grey{99, 99, 99};
  View view = close_view();
  view.backdrop = Backdrop{.centre = grey, .edge = grey};
  const Image image = drawn(open_mouth(), view, spots);
  EXPECT_GT(count_of(image, {99, 99, 99}), 160 * 160 - 2000);
}

TEST(PartNames, EachStandForSomePart) {
  PartSet named;
  for (const auto name : part_names()) {
    const auto parts = parts_named(name);
    ASSERT_TRUE(parts.has_value()) << name;
    EXPECT_TRUE(parts->any()) << name;
    named |= *parts;
  }
  EXPECT_EQ(named, all_parts());
  EXPECT_FALSE(parts_named("nose").has_value());
}

}  // namespace
}  // namespace bimodal::synth
