#include "synth/face/eyes.hpp"

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"
#include "synth/face/eyeball.hpp"
#include "synth/face/obj_reader.hpp"

namespace bimodal::synth {
namespace {

std::vector<RigidPart> left_eye() {
  const auto mesh = asset("synth/assets/head/head.obj");
  return eye_parts(part(read_obj(mesh), "left_eye", mesh), true);
}

TEST(Eyes, AreBallWhiteAndCorneaOfWhichTheWhiteAloneDoesNotTurn) {
  const auto parts = left_eye();
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0].carrier, RigidPart::Carrier::LeftEye);
  EXPECT_EQ(parts[1].carrier, RigidPart::Carrier::Head);
  EXPECT_EQ(parts[2].carrier, RigidPart::Carrier::LeftEye);
}

TEST(Eyes, ShowTheIrisBeforeTheWhiteAndHideTheRestOfTheBallBehindIt) {
  constexpr double kIrisDeg = 29.1;
  const auto ball = left_eye()[0];
  for (const auto& point : ball.at_rest.positions) {
    const auto out = glm::dvec3{point} - kLeftEyeCentre;
    const double angle = glm::degrees(std::atan2(std::hypot(out.x, out.y), out.z));
    if (angle < kIrisDeg) {
      EXPECT_GT(glm::length(out), kEyeRadius + 0.1);
    }
    if (angle > 40.5) {
      EXPECT_LT(glm::length(out), kEyeRadius - 0.3);
    }
  }
}

TEST(Eyes, HaveAWhiteThatIsTheBallWhereTheIrisLooksAndFallsSmoothlyToTheCorners) {
  const auto white = left_eye()[1];
  for (std::size_t i = 0; i < white.at_rest.positions.size(); ++i) {
    const glm::dvec3 out = glm::dvec3{white.at_rest.positions[i]} - kLeftEyeCentre;
    const bool on_the_ball = std::hypot(out.x, out.y) < 0.8 * kEyeRadius && out.x > -8.0;
    if (!on_the_ball) continue;
    EXPECT_NEAR(glm::length(out), kEyeRadius, 0.02);
    EXPECT_GT(glm::dot(glm::dvec3{white.at_rest.normals[i]}, glm::normalize(out)), 0.999);
  }
  const auto& triangles = white.description.triangles;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    constexpr float kBesideCaruncle = 22.0F;
    if (white.at_rest.positions[triangles[t]].x < kBesideCaruncle) continue;
    const auto& normal = white.at_rest.normals[triangles[t]];
    EXPECT_GT(glm::dot(normal, white.at_rest.normals[triangles[t + 1]]), 0.95F) << "a sharp edge";
    EXPECT_GT(glm::dot(normal, white.at_rest.normals[triangles[t + 2]]), 0.95F) << "a sharp edge";
  }
}

TEST(Eyes, MirrorEachOther) {
  const auto mesh = asset("synth/assets/head/head.obj");
  const auto cages = read_obj(mesh);
  const auto left = eye_parts(part(cages, "left_eye", mesh), true)[1];
  const auto right = eye_parts(part(cages, "right_eye", mesh), false)[1];
  ASSERT_EQ(left.at_rest.positions.size(), right.at_rest.positions.size());
  for (std::size_t i = 0; i < left.at_rest.positions.size(); ++i) {
    const glm::vec3 mirror{-1.0F, 1.0F, 1.0F};
    EXPECT_EQ(left.at_rest.positions[i], mirror * right.at_rest.positions[i]);
    EXPECT_EQ(left.at_rest.normals[i], mirror * right.at_rest.normals[i]);
    EXPECT_EQ(left.description.rest_positions[i], right.description.rest_positions[i]);
  }
}

}  // namespace
}  // namespace bimodal::synth
