// Damaged materials become materials that can be drawn, or mistakes with their lines; never
// anything else.

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/digest.hpp"
#include "synth/render/material_rows.hpp"
#include "tests/support/damage.hpp"

namespace bimodal::synth {
namespace {

constexpr int kMutations = 5'000;

/// What shaders rely on.
void expect_drawable(const Materials& materials) {
  for (const auto& row : light_rows()) {
    const glm::vec3& light = materials.*row.member;
    if (row.is_direction) {
      ASSERT_NEAR(glm::length(light), 1.0F, 2e-3F) << row.key;
    } else {
      for (const float channel : {light.x, light.y, light.z}) {
        ASSERT_TRUE(channel >= 0.0F && channel <= 10.0F) << row.key;
      }
    }
  }
  for (const auto& row : amount_rows()) {
    const auto amount = static_cast<double>(materials.*row.member);
    ASSERT_TRUE(amount >= row.lowest && amount <= row.highest) << row.key;
  }
}

void judge(const std::string& text, int& accepted) {
  std::vector<Diagnostic> diagnostics;
  const auto materials = Materials::parse(text, "x.json", diagnostics);
  ASSERT_NE(materials.has_value(), has_errors(diagnostics)) << text;
  const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
  for (const auto& diagnostic : diagnostics) {
    ASSERT_EQ(diagnostic.file, "x.json");
    ASSERT_LE(diagnostic.line, lines);
    ASSERT_FALSE(diagnostic.finding.empty() || diagnostic.remedy.empty());
  }
  if (!materials) return;
  ++accepted;
  expect_drawable(*materials);
}

TEST(MaterialsFuzz, DamagedFilesAreMaterialsOrMistakes) {
  const auto natural = read_file(asset("synth/assets/materials/natural.json"));
  Damage damage{1};
  int accepted = 0;
  for (int i = 0; i < kMutations; ++i) ASSERT_NO_FATAL_FAILURE(judge(damage(natural), accepted));
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, kMutations);
}

TEST(MaterialsFuzz, ValuesOfEveryKindAreTakenOrRefusedAtTheirPlace) {
  using Json = nlohmann::json;
  const auto natural = Json::parse(read_file(asset("synth/assets/materials/natural.json")));
  const std::vector<Json> kinds{nullptr,
                                true,
                                -1e300,
                                1e300,
                                0.5,
                                "",
                                "x",
                                Json::array(),
                                Json::array({0, 0, 0}),
                                Json::array({1, 2}),
                                Json::array({-1, 256, 1e9}),
                                Json::object()};
  int accepted = 0;
  const auto flat = natural.flatten();
  for (const auto& [pointer, leaf] : flat.items()) {
    for (auto end = pointer.size(); end > 0; end = pointer.rfind('/', end - 1)) {
      for (const auto& kind : kinds) {
        auto changed = natural;
        changed[Json::json_pointer{pointer.substr(0, end)}] = kind;
        ASSERT_NO_FATAL_FAILURE(judge(changed.dump(1), accepted));
      }
    }
  }
  EXPECT_GT(accepted, 0);
}

}  // namespace
}  // namespace bimodal::synth
