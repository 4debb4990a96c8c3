#include "synth/render/materials.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/error.hpp"
#include "synth/render/material_rows.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::synth {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// All messages about a text, one a line.
std::string complaints(std::string_view text) {
  std::vector<Diagnostic> diagnostics;
  const auto materials = Materials::parse(text, "mine.json", diagnostics);
  EXPECT_EQ(materials.has_value(), !has_errors(diagnostics));
  std::string all;
  for (const auto& diagnostic : diagnostics) all += describe(diagnostic) + "\n";
  return all;
}

Materials parsed(std::string_view text) {
  std::vector<Diagnostic> diagnostics;
  return Materials::parse(text, "mine.json", diagnostics).value();
}

TEST(Materials, CalledNaturalAreTheDefaults) {
  EXPECT_EQ(Materials::named("natural"), Materials{});
}

TEST(Materials, ThatShipAreAllReadable) {
  const auto presets = asset_names("synth/assets/materials", ".json");
  EXPECT_THAT(
      presets,
      testing::IsSupersetOf({"natural", "clay", "high-contrast", "paper-1993", "dark-skin"}));
  for (const auto& preset : presets)
    EXPECT_NO_THROW(static_cast<void>(Materials::named(preset))) << preset;
}

TEST(Materials, LeftOutOfAFileStayNatural) {
  const auto materials = parsed(R"({"lips": {"inner": [200, 10, 20]}, "shading": "flat"})");
  EXPECT_EQ(materials.lips_inner, (Colour{200, 10, 20}));
  EXPECT_EQ(materials.shading, Shading::Flat);
  EXPECT_EQ(materials.skin, Materials{}.skin);
}

TEST(Materials, TellAllMistakesOfAFileAtOnce) {
  const auto told = complaints(R"({
    "skin": {"colour": [226, 178, 350], "colr": [1, 2, 3]},
    "lips": {"inner": "red"},
    "light": {"key_direction": [0, 0, 0], "exposure": "bright"},
    "surface": {"gloss": -1},
    "shading": "phong",
    "nose": {}
  })");
  EXPECT_THAT(
      told,
      AllOf(HasSubstr("mine.json:2: /skin/colour/2: 350 is outside 0 to 255; give red, green"),
            HasSubstr("mine.json:2: /skin/colr: the key \"colr\" is not known; did you mean "
                      "\"colour\"?"),
            HasSubstr("mine.json:3: /lips/inner: \"red\" is not an array"),
            HasSubstr("mine.json:4: /light/key_direction: this points nowhere"),
            HasSubstr("mine.json:4: /light/exposure: \"bright\" is not a number"),
            HasSubstr("mine.json:5: /surface/gloss: -1 is outside 0 to 4"),
            HasSubstr("mine.json:6: /shading: \"phong\" is not known"),
            HasSubstr("mine.json:7: /nose: the key \"nose\" is not known")));
}

TEST(Materials, TellWhereATextIsNoJson) {
  EXPECT_THAT(complaints("{\n\"skin\": \n}"), HasSubstr("mine.json:3"));
  EXPECT_THAT(complaints("[]"), HasSubstr("is not an object"));
}

TEST(Materials, TurnALightsDirectionIntoUnitLength) {
  const auto materials = parsed(R"({"light": {"key_direction": [0, 3, 4]}})");
  EXPECT_FLOAT_EQ(materials.key_direction.y, 0.6F);
  EXPECT_FLOAT_EQ(materials.key_direction.z, 0.8F);
}

TEST(Materials, AreFoundByTheNameOfAPresetOrOfAFile) {
  const WrittenFiles files;
  const auto mine = files.write("mine.json", R"({"skin": {"colour": [1, 2, 3]}})");
  EXPECT_EQ(Materials::named(mine.string()).skin, (Colour{1, 2, 3}));
  try {
    static_cast<void>(Materials::named("clya"));
    FAIL() << "nothing was complained of";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("'clya'"), HasSubstr("clay")));
  }
}

TEST(Materials, AreConstantsForShadersEachOnce) {
  const auto text = shader_constants({});
  EXPECT_THAT(text, HasSubstr("const vec3 kSkin = vec3(226.0, 178.0, 150.0);\n"));
  EXPECT_THAT(text, HasSubstr("const float kTexture = 1.0;\n"));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
  for (const auto& row : colour_rows()) {
    const auto name = " " + std::string{row.constant} + " ";
    EXPECT_EQ(text.find(name), text.rfind(name)) << row.constant;
  }
}

}  // namespace
}  // namespace bimodal::synth
