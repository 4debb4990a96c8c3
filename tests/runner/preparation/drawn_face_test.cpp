// What a protocol asks of the face, and what is drawn.

#include "runner/preparation/drawn_face.hpp"

#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "runner/preparation/drawing_pace.hpp"
#include "runner/preparation/face_terms.hpp"
#include "runner/preparation/live_faces.hpp"
#include "runner/preparation/view_names.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "tests/support/face_terms.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::runner {
namespace {

using protocols::Face;
using synth::Control;
using synth::HeadPart;
using testing::ElementsAre;

TEST(FaceTerms, AreThoseOfTheFaceThatShips) {
  const auto terms = face_terms();
  const auto written = protocols::known_face_terms();
  EXPECT_EQ(terms.views, written.views);
  EXPECT_EQ(terms.points, written.points);
  EXPECT_EQ(terms.materials, written.materials);
  EXPECT_EQ(terms.speech_controls, written.speech_controls);
  EXPECT_TRUE(std::ranges::equal(terms.parts, written.parts, [](const auto& a, const auto& b) {
    return a.name == b.name && a.parts == b.parts;
  }));
  EXPECT_TRUE(
      std::ranges::equal(terms.expressions, written.expressions, [](const auto& a, const auto& b) {
        return a.name == b.name && a.adds == b.adds;
      }));
  EXPECT_TRUE(
      std::ranges::equal(terms.controls, written.controls, [](const auto& a, const auto& b) {
        return a.name == b.name && a.unit == b.unit && a.lowest == b.lowest &&
               a.highest == b.highest;
      }));
}

// Protocols take it for granted: what is not set is at 0.
TEST(FaceTerms, HaveControlsThatRestAtZero) {
  for (const auto& control : face_terms().controls) {
    EXPECT_EQ(synth::describe(synth::control_from_name(control.name).value()).neutral, 0.0);
  }
}

TEST(DrawnFace, IsByDefaultTheWholeHeadFromTheFront) {
  const auto appearance = appearance_of({}, synth::Quality::Fast);
  EXPECT_EQ(appearance.shown, synth::all_parts());
  EXPECT_EQ(appearance.skin_transparency, 0.0);
  EXPECT_EQ(appearance.points, synth::Points::None);
  EXPECT_EQ(appearance.materials, synth::Materials{});
  EXPECT_EQ(appearance.samples, 1);
  const auto view = view_of({}, 720, 0x102030);
  EXPECT_EQ(view.width, 640U);
  EXPECT_EQ(view.yaw_deg, 0.0);
  EXPECT_EQ(view.centre_y_mm, -32.0);
  EXPECT_EQ(view.field_mm, 312.0);
  EXPECT_EQ(view.backdrop, (synth::Backdrop{.centre = {16, 32, 48}, .edge = {16, 32, 48}}));
}

TEST(DrawnFace, ShowsWhatIsShownAndNotHidden) {
  const auto shown = [](const Face& face) { return appearance_of(face, {}).shown; };
  EXPECT_FALSE(has(shown({.hide = {"tongue"}}), HeadPart::Tongue));
  EXPECT_EQ(shown({.hide = {"tongue"}}).count(), synth::kHeadPartCount - 1);
  const auto mouth = shown({.show = {"lips", "teeth"}, .hide = {"lower_teeth"}});
  EXPECT_EQ(mouth.count(), 2U);
  EXPECT_TRUE(has(mouth, HeadPart::Lips) && has(mouth, HeadPart::UpperTooth));
}

TEST(DrawnFace, HasPointsOfLightInMaterialsOfTheirOwn) {
  const auto points = appearance_of({.points = "lips"}, {});
  EXPECT_EQ(points.points, synth::Points::Lips);
  EXPECT_EQ(points.materials, synth::Materials::named("point-light"));
  EXPECT_EQ(appearance_of({.material = "clay", .points = "lips"}, {}).materials,
            synth::Materials::named("clay"));
}

TEST(DrawnFace, IsSeenFromEveryNamedView) {
  EXPECT_EQ(view_of({.view = "side"}, 90, 0).yaw_deg, 90.0);
  EXPECT_EQ(view_of({.view = "mouth"}, 90, 0).field_mm, 120.0);
  for (const auto name : view_names()) {
    EXPECT_EQ(shows_whole_head(name), name != "mouth");
    EXPECT_EQ(view_of({.view = std::string{name}}, 90, 0).height, 90U);
  }
  EXPECT_THROW(static_cast<void>(view_of({.view = "behind"}, 90, 0)), Error);
}

TEST(Bearings, LeaveSpeechAsItIs) {
  const auto bearing = bearing_of(
      {.expression = {{"surprise", 0.5}}, .controls = {{"gaze_x", -12}, {"brow_raise", 1}}});
  auto speech = synth::neutral_pose();
  value(speech, Control::LipProtrusion) = 4;
  const auto pose = bearing.of(speech);
  EXPECT_EQ(value(pose, Control::LipProtrusion), 4);
  EXPECT_EQ(value(pose, Control::GazeX), -12);
  EXPECT_EQ(value(pose, Control::BrowRaise), 1 + 0.5 * 7);
  EXPECT_EQ(bearing_of({}).of(speech), speech);
}

TEST(FaceRecord, TellsEverythingButTheFolders) {
  const WrittenFiles files;
  const auto mine = files.write("mine.json", R"({"surface": {"gloss": 1}})");
  const auto record = nlohmann::json::parse(face_record({.view = "side",
                                                         .material = mine.string(),
                                                         .show = {"teeth", "tongue"},
                                                         .transparency = 0.25,
                                                         .expression = {{"smile", 0.5}},
                                                         .controls = {{"gaze_x", -3}}}));
  EXPECT_EQ(record.at("view"), "side");
  EXPECT_EQ(record.at("material"), "mine.json");
  EXPECT_EQ(record.at("material_sha256"), sha256_of_file(mine));
  EXPECT_THAT(record.at("shown").get<std::vector<std::string>>(),
              ElementsAre("teeth", "upper_teeth", "lower_teeth", "tongue"));
  EXPECT_EQ(record.at("expression"), nlohmann::json({{"smile", 0.5}}));
  EXPECT_EQ(record.at("controls"), nlohmann::json({{"gaze_x", -3}}));
  EXPECT_EQ(record.dump().find(files.folder().string()), std::string::npos);
}

TEST(FaceRecord, OfAnUnsaidMaterialNamesTheOneThatIsDrawn) {
  EXPECT_EQ(nlohmann::json::parse(face_record({})).at("material"), "natural");
  EXPECT_EQ(nlohmann::json::parse(face_record({.points = "all"})).at("material"), "point-light");
}

// The schema must say the same as the face; the reader, and what it is told, are held together
// above.
TEST(FaceTerms, AreThoseOfTheSchema) {
  const auto schema =
      nlohmann::json::parse(read_file(asset("protocols/schema/protocol.schema.json")));
  const auto& definitions = schema.at("$defs");
  const auto& face = definitions.at("appearance").at("properties");
  const auto terms = face_terms();
  EXPECT_EQ(face.at("view").at("enum"), nlohmann::json(terms.views));
  EXPECT_EQ(face.at("points").at("enum"), nlohmann::json(terms.points));
  std::vector<std::string_view> parts;
  for (const auto& part : terms.parts) parts.push_back(part.name);
  EXPECT_EQ(definitions.at("parts").at("items").at("enum"), nlohmann::json(parts));
  EXPECT_EQ(face.at("expression").at("properties").size(), terms.expressions.size());
  for (const auto& expression : terms.expressions) {
    EXPECT_TRUE(face.at("expression").at("properties").contains(expression.name));
  }
  const auto& controls = face.at("controls").at("properties");
  EXPECT_EQ(controls.size(), terms.controls.size());
  for (const auto& control : terms.controls) {
    EXPECT_EQ(controls.at(std::string{control.name}).at("minimum"), control.lowest);
    EXPECT_EQ(controls.at(std::string{control.name}).at("maximum"), control.highest);
  }
}

TEST(CostliestFace, IsTheOneOfWhichMostIsDrawn) {
  protocols::Protocol protocol;
  const auto add = [&](const std::string& name, const Face& face) {
    protocol.conditions.push_back({.name = name, .visual_talker = "face", .face = face});
  };
  add("lips", {.show = {"lips"}});
  add("whole", {});
  add("no tongue", {.hide = {"tongue"}});
  std::vector<protocols::PlannedTrial> plan(3);
  for (std::size_t i = 0; i < plan.size(); ++i) plan[i].condition = i;
  EXPECT_EQ(costliest_face(protocol, plan, {}).value().face, Face{});
  add("see-through", {.transparency = 0.5});
  EXPECT_EQ(costliest_face(protocol, plan, {}).value().face, Face{});  // in no trial
  plan.push_back({.condition = 3});
  EXPECT_EQ(costliest_face(protocol, plan, {}).value().face.transparency, 0.5);
}

TEST(LiveFaces, AreMadeWhenTheyAreNeededAndNeverMany) {
  LiveFaces faces{synth::Quality::Fast, 2};
  const auto look = [](std::string view) {
    return ShownLook{.height = 64, .lines = 64, .face = {.view = std::move(view)}};
  };
  const auto* const front = &faces.face(look("front"));
  EXPECT_EQ(faces.count(), 1U);
  auto smiling = look("front");
  smiling.face.expression["smile"] = 1;
  smiling.height = 128;
  smiling.blur_px = 2;
  EXPECT_EQ(&faces.face(smiling), front);  // the same face in another bearing
  static_cast<void>(faces.face(look("side")));
  EXPECT_EQ(&faces.face(look("front")), front);
  static_cast<void>(faces.face(look("mouth")));  // "side" gives way
  EXPECT_EQ(faces.count(), 2U);
  EXPECT_EQ(&faces.face(look("front")), front);
}

}  // namespace
}  // namespace bimodal::runner
