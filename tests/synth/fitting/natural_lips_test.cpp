// The fit against measured lips and against the fit of them that the shipped dynamics come from.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "synth/fitting/definitions.hpp"
#include "synth/fitting/fit_problem.hpp"
#include "synth/fitting/leave_one_out.hpp"
#include "synth/speech/claims.hpp"
#include "tests/synth/fitting/lips_data.hpp"

namespace bimodal::synth {
namespace {

constexpr const char* kNoData = "BIMODAL_TEST_DATA does not name a folder with lips/";

/// fit_params.csv: the parameters of that fit, phone by phone.
std::vector<PartDynamics> published(const std::filesystem::path& folder,
                                    const std::string& measure) {
  const std::map<std::string, std::string> names{{"AY1", "AY start"},
                                                 {"AY2", "AY end"},
                                                 {"AW1", "AW start"},
                                                 {"AW2", "AW end"},
                                                 {"EY1", "EY start"},
                                                 {"EY2", "EY end"},
                                                 {"SIL", "rest"}};
  std::vector<PartDynamics> dynamics(parts().size());
  std::ifstream in{folder / "fit_params.csv"};
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields{line};
    std::vector<std::string> field;
    for (std::string one; std::getline(fields, one, ',');) field.push_back(one);
    if (field.at(0) != measure || field.at(1) != "phone") continue;
    const auto other = names.find(field.at(2));
    const auto part = part_named(other == names.end() ? field.at(2) : other->second);
    if (!part) {
      ADD_FAILURE() << "no part " << field.at(2);
      continue;
    }
    const double log_theta = std::log(std::stod(field.at(7)));
    dynamics.at(*part) = {.target = std::stod(field.at(5)),
                          .log_alpha = std::log(std::stod(field.at(6))),
                          .log_theta_before = log_theta,
                          .log_theta_after = log_theta,
                          .offset_ms = std::stod(field.at(8))};
  }
  return dynamics;
}

/// With the gain or the offset of each clip that fits it best.
Agreement agreement_of_published(const std::filesystem::path& folder, const std::string& measure) {
  const Fit known{.kind = kind_of(measure), .dynamics = published(folder, measure)};
  std::vector<Agreement> all;
  for (const auto& clip : lip_clips(folder, measure)) {
    auto told = predicted(known, clip, 0);
    double talker = 0;
    if (known.kind == MeasureKind::Opening) {
      const double own = std::inner_product(told.begin(), told.end(), told.begin(), 0.0);
      const double common = std::inner_product(told.begin(), told.end(), clip.values.begin(), 0.0);
      talker = std::log(common / own);
    } else {
      const double sum = std::accumulate(clip.values.begin(), clip.values.end(), 0.0) -
                         std::accumulate(told.begin(), told.end(), 0.0);
      talker = sum / static_cast<double>(told.size());
    }
    all.push_back(agreement(predicted(known, clip, talker), clip.values));
  }
  return over_clips(all);
}

TEST(PublishedFit, OfInnerHeightHasTheAgreementThatItIsSaidToHave) {
  const auto folder = lips_folder();
  if (!folder) GTEST_SKIP() << kNoData;
  const auto found = agreement_of_published(*folder, "inner_h");
  EXPECT_EQ(found.instants, 266);
  EXPECT_NEAR(found.rmse(), 1.67, 0.005);
  EXPECT_NEAR(found.r.value(), 0.91, 0.005);
}

TEST(PublishedFit, OfOuterWidthHasTheAgreementThatItIsSaidToHave) {
  const auto folder = lips_folder();
  if (!folder) GTEST_SKIP() << kNoData;
  const auto found = agreement_of_published(*folder, "outer_w");
  EXPECT_NEAR(found.rmse(), 1.25, 0.005);
  EXPECT_NEAR(found.r.value(), 0.79, 0.005);
}

TEST(NaturalLips, TellTheInnerHeightOfAClipThatWasLeftOut) {
  const auto folder = lips_folder();
  if (!folder) GTEST_SKIP() << kNoData;
  const auto clips = lip_clips(*folder, "inner_h");
  const auto left_out = over_clips(leave_one_out(
      clips, {.kind = MeasureKind::Opening, .theta_per_ms = 0.022, .shrinkage = 0.35}));
  EXPECT_GE(left_out.r.value(), 0.84);
  EXPECT_LE(left_out.rmse(), 2.95);
  EXPECT_LE(left_out.rmse_scaled(), 2.30);
}

TEST(NaturalLips, TellTheOuterWidthOfAClipThatWasLeftOut) {
  const auto folder = lips_folder();
  if (!folder) GTEST_SKIP() << kNoData;
  const auto clips = lip_clips(*folder, "outer_w");
  const auto left_out = over_clips(leave_one_out(
      clips, {.kind = MeasureKind::Position, .theta_per_ms = 0.010, .shrinkage = 0.7}));
  EXPECT_GE(left_out.r.value(), 0.64);
  EXPECT_LE(left_out.rmse(), 1.91);
  EXPECT_LE(left_out.rmse_scaled(), 1.50);
}

TEST(NaturalLips, CloseInEveryBilabialOfTheFit) {
  const auto folder = lips_folder();
  if (!folder) GTEST_SKIP() << kNoData;
  const auto clips = lip_clips(*folder, "inner_h");
  const auto found = fit(clips, {.kind = MeasureKind::Opening, .theta_per_ms = 0.022});
  std::size_t bilabials = 0;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    for (const auto& spoken : clips[i].spoken) {
      if (parts()[spoken.part].class_name != "P B M") continue;
      auto moment = clips[i];
      moment.time_ms = {spoken.centre_ms - 40, spoken.centre_ms - 20, spoken.centre_ms};
      const auto height = predicted(found, moment, found.talkers[i]);
      EXPECT_LT(*std::ranges::min_element(height), 0.7) << clips[i].name;
      ++bilabials;
    }
  }
  EXPECT_EQ(bilabials, 9);
}

/// What the face's own segments and claims make of a fit's definitions.
std::vector<double> told_by_segments(const Fit& found,
                                     const Utterance& utterance,
                                     const MeasuredClip& clip,
                                     double talker) {
  const auto segments = segments_of(utterance);
  std::vector<Claim> claims;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto asked = dynamics_of(found, segments[i].segment.from).value();
    const auto& timed = segments[i];
    const bool begins = i == 0;
    const bool ends = i + 1 == segments.size();
    Milliseconds centre = timed.centre();
    if (begins) centre = timed.end() - kRestDistance;
    if (ends) centre = timed.start + kRestDistance;
    claims.push_back({.peak = centre + Milliseconds{asked.offset_ms},
                      .target = asked.target,
                      .dominance = {.alpha = std::exp(asked.log_alpha),
                                    .theta_before = begins ? 0 : std::exp(asked.log_theta_before),
                                    .theta_after = ends ? 0 : std::exp(asked.log_theta_after)}});
  }
  std::vector<double> told;
  for (const double time : clip.time_ms) {
    told.push_back(shown(found.kind, blend(claims, Milliseconds{time}), talker));
  }
  return told;
}

TEST(NaturalLips, AreToldByTheSegmentsOfTheFaceAsWell) {
  const auto folder = lips_folder();
  if (!folder) GTEST_SKIP() << kNoData;
  const auto clips = lip_clips(*folder, "inner_h");
  const auto found =
      fit(clips, {.kind = MeasureKind::Opening, .theta_per_ms = 0.022, .shrinkage = 0.35});
  std::vector<Agreement> all;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const auto labels = read_labels(*folder / (clips[i].name + ".TextGrid"));
    const auto told = told_by_segments(
        found, utterance_of(*phone_tier(labels), labels.end), clips[i], found.talkers[i]);
    all.push_back(agreement(told, clips[i].values));
  }
  EXPECT_GT(over_clips(all).r.value(), 0.88);  // .91 with halves of their own
  EXPECT_LT(over_clips(all).rmse(), 2.0);
}

TEST(Choice, FindsTheThetaThatTellsLeftOutClipsBest) {
  const auto folder = lips_folder();
  if (!folder) GTEST_SKIP() << kNoData;
  const auto clips = lip_clips(*folder, "inner_h");
  std::size_t told = 0;
  const auto chosen = choose(clips,
                             {.kind = MeasureKind::Opening},
                             {.shrinkages = {0.5}, .thetas_per_ms = {0.0075, 0.022, 0.07}},
                             [&](const Chosen&) { ++told; });
  EXPECT_EQ(chosen.options.theta_per_ms, 0.022);
  EXPECT_GT(over_clips(chosen.left_out).r.value(), 0.84);
  EXPECT_EQ(chosen.left_out.size(), clips.size());
  EXPECT_GE(told, 4);
}

}  // namespace
}  // namespace bimodal::synth
