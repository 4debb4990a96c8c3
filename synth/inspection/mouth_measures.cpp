#include "synth/inspection/mouth_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "synth/face/jaw.hpp"
#include "synth/face/palate.hpp"
#include "synth/face/surface_tree.hpp"
#include "synth/inspection/firm_part.hpp"
#include "synth/inspection/front_view.hpp"

namespace bimodal::synth {

namespace {

constexpr std::array kSeenFromFront{HeadSurface::Skin,
                                    HeadSurface::Tongue,
                                    HeadSurface::UpperTeeth,
                                    HeadSurface::LowerTeeth,
                                    HeadSurface::UpperGum,
                                    HeadSurface::LowerGum,
                                    HeadSurface::Palate};

constexpr float kFarthest = 30.0F;        // mm; nothing farther is told apart
constexpr float kIncisorsHalfWidth = 15;  // mm: the four upper incisors
constexpr double kIncisorsBack = 90.5;    // z of the back of the upper incisors' edges
constexpr double kRidgeDepth = 9.0;       // mm behind the incisors' necks
constexpr double kRidgeHalfWidth = 7.0;   // mm
constexpr float kLip = 0.5F;              // of the lip mask: from the vermilion border inward
constexpr float kLowerLip = 0.9F;         // of its mask
constexpr float kMidTongue = 9.0F;        // mm either side of the midline
constexpr float kRootEnds = 50.0F;        // z; behind it the root grows out of the floor
constexpr float kMouthSkin = 0.3F;        // of the lip mask: what may meet the teeth

Pose facing_ahead(Pose pose) {
  for (const Control turn : {Control::HeadYaw, Control::HeadPitch, Control::HeadRoll}) {
    value(pose, turn) = 0;
  }
  return pose;
}

std::vector<std::uint32_t> where(const SurfaceDescription& surface, auto&& holds) {
  std::vector<std::uint32_t> triangles;
  for (std::size_t t = 0; t + 3 <= surface.triangles.size(); t += 3) {
    const auto corners = std::span{surface.triangles}.subspan(t, 3);
    if (std::ranges::all_of(corners, holds)) {
      triangles.insert(triangles.end(), corners.begin(), corners.end());
    }
  }
  return triangles;
}

/// How far to look for something nearer than `nearest`, which may lie inside: then deeper counts.
float worth_looking(float nearest) {
  return std::max(nearest, FirmPart::kDeepest);
}

/// Calls visit(point) at the corners and in the middle of every triangle.
void for_each_sample(std::span<const glm::vec3> positions,
                     std::span<const std::uint32_t> triangles,
                     auto&& visit) {
  for (std::size_t t = 0; t + 3 <= triangles.size(); t += 3) {
    const auto& a = positions[triangles[t]];
    const auto& b = positions[triangles[t + 1]];
    const auto& c = positions[triangles[t + 2]];
    visit(a);
    visit((a + b + c) / 3.0F);
  }
}

/// Where posed points would be with the teeth at rest.
class ToothFrames {
 public:
  explicit ToothFrames(const Pose& pose = neutral_pose())
      : offset_{value(pose, Control::TeethX), 0.0, value(pose, Control::TeethZ)},
        jaw_{.opening_deg = value(pose, Control::Jaw),
             .thrust_mm = value(pose, Control::JawThrust)} {}

  [[nodiscard]] glm::vec3 upper(const glm::vec3& point) const {
    return glm::vec3{glm::dvec3{point} - offset_};
  }

  [[nodiscard]] glm::vec3 lower(const glm::vec3& point) const {
    return glm::vec3{jaw_.undo(glm::dvec3{point} - offset_)};
  }

 private:
  glm::dvec3 offset_;
  JawMotion jaw_;
};

/// Within the drawn palate's outline; `point` in the frame of the upper teeth.
bool under_palate(const glm::vec3& point) {
  const auto z = static_cast<double>(point.z);
  return z > kPalateBack && z < kPalateFront &&
         static_cast<double>(std::abs(point.x)) < palate_half_width(z) - 0.5;
}

}  // namespace

double Penetrations::worst() const {
  return std::max({lip_in_lip, flesh_in_teeth, tongue_in_teeth, tongue_in_palate, tongue_in_flesh});
}

struct MouthRuler::Tools {
  explicit Tools(const Head& measured)
      : head{measured},
        resting{posed_at(neutral_pose())},
        upper_teeth{firm(HeadSurface::UpperTeeth)},
        lower_teeth{firm(HeadSurface::LowerTeeth)},
        palate{tree(HeadSurface::Palate)},
        ridge{palate_part(true)},
        behind_ridge{palate_part(false)},
        lower_lip{where(description(HeadSurface::Skin),
                        [&](std::uint32_t v) {
                          const auto& skin = description(HeadSurface::Skin);
                          return skin.lip[v] > kLip && skin.lower[v] > kLowerLip;
                        })},
        mouth_skin{where(description(HeadSurface::Skin), [&](std::uint32_t v) {
          const auto& skin = description(HeadSurface::Skin);
          return skin.lip[v] > kMouthSkin || skin.wet[v] > 0.0F;
        })} {}

  [[nodiscard]] const SurfaceDescription& description(HeadSurface name) const {
    return head.surfaces()[static_cast<std::size_t>(name)];
  }

  [[nodiscard]] PosedHead posed_at(const Pose& at) const {
    PosedHead result;
    head.pose(at, result);
    return result;
  }

  [[nodiscard]] SurfaceTree tree(HeadSurface name) const {
    return {resting.at(name).positions, description(name).triangles};
  }

  [[nodiscard]] FirmPart firm(HeadSurface name) const {
    return {resting.at(name).positions, description(name).triangles};
  }

  [[nodiscard]] SurfaceTree palate_part(bool of_ridge) const {
    const auto& surface = description(HeadSurface::Palate);
    return {resting.at(HeadSurface::Palate).positions, where(surface, [&](std::uint32_t v) {
              const auto& point = surface.rest_positions[v];
              const bool on_ridge = static_cast<double>(point.z) > kPalateFront - kRidgeDepth &&
                                    static_cast<double>(std::abs(point.x)) < kRidgeHalfWidth;
              return on_ridge == of_ridge;
            })};
  }

  const Head& head;
  PosedHead resting;
  FirmPart upper_teeth;
  FirmPart lower_teeth;
  SurfaceTree palate;
  SurfaceTree ridge;
  SurfaceTree behind_ridge;
  std::vector<std::uint32_t> lower_lip;   // triangles of the skin
  std::vector<std::uint32_t> mouth_skin;  // triangles of the skin
  Pose pose{};
  PosedHead posed;
  ToothFrames frames;
  FrontView view;
};

MouthRuler::MouthRuler(const Head& head) : tools_{std::make_unique<Tools>(head)} {
  take(neutral_pose());
}

MouthRuler::~MouthRuler() = default;

void MouthRuler::take(const Pose& pose) {
  tools_->pose = within_range(facing_ahead(pose));
  tools_->head.pose(tools_->pose, tools_->posed);
  tools_->frames = ToothFrames{tools_->pose};
}

const LipMeasures& MouthRuler::lips() const {
  return tools_->posed.lips;
}

double MouthRuler::lip_to_incisors_mm() const {
  float nearest = kFarthest;
  for_each_sample(tools_->posed.at(HeadSurface::Skin).positions,
                  tools_->lower_lip,
                  [&](const glm::vec3& point) {
                    if (std::abs(point.x) > kIncisorsHalfWidth) return;
                    nearest = std::min(nearest,
                                       tools_->upper_teeth.tree().signed_distance(
                                           tools_->frames.upper(point), worth_looking(nearest)));
                  });
  return static_cast<double>(nearest);
}

SeenAreas MouthRuler::seen() {
  auto& view = tools_->view;
  view.clear();
  for (const HeadSurface name : kSeenFromFront) {
    view.draw(tools_->posed.at(name).positions,
              tools_->description(name).triangles,
              static_cast<std::uint8_t>(name));
  }
  const auto area = [&](HeadSurface name) { return view.area_of(static_cast<std::uint8_t>(name)); };
  return {.upper_teeth_mm2 = area(HeadSurface::UpperTeeth),
          .lower_teeth_mm2 = area(HeadSurface::LowerTeeth),
          .tongue_mm2 = area(HeadSurface::Tongue),
          .tongue_between_teeth_mm2 =
              view.area_of(static_cast<std::uint8_t>(HeadSurface::Tongue),
                           kIncisorsBack + value(tools_->pose, Control::TeethZ))};
}

TonguePlace MouthRuler::tongue() const {
  // The blade: from 11 to 21 mm behind the necks of the incisors, and only where it is raised. mm.
  constexpr double kBladeFrom = 68;
  constexpr double kBladeTo = 78;
  constexpr double kUnderPalate = -74;
  float to_ridge = kFarthest;
  float to_palate = kFarthest;
  double beside = palate_half_width(kBladeFrom);
  for (const glm::vec3& point : tools_->posed.at(HeadSurface::Tongue).positions) {
    const auto at = tools_->frames.upper(point);
    to_ridge = std::min(to_ridge, tools_->ridge.signed_distance(at, worth_looking(to_ridge)));
    if (!under_palate(at)) continue;
    to_palate =
        std::min(to_palate, tools_->behind_ridge.signed_distance(at, worth_looking(to_palate)));
    const glm::dvec3 place{at};
    if (place.z > kBladeFrom && place.z < kBladeTo && place.y > kUnderPalate) {
      beside = std::min(beside, palate_half_width(place.z) - std::abs(place.x));
    }
  }
  return {.to_ridge_mm = static_cast<double>(to_ridge),
          .to_palate_mm = static_cast<double>(to_palate),
          .beside_mm = beside};
}

Penetrations MouthRuler::penetrations() const {
  const auto& frames = tools_->frames;
  const auto& skin = tools_->posed.at(HeadSurface::Skin).positions;
  const SurfaceTree flesh{skin, tools_->mouth_skin};
  const auto in_teeth = [&](const glm::vec3& point) {
    return std::max(tools_->upper_teeth.depth(frames.upper(point)),
                    tools_->lower_teeth.depth(frames.lower(point)));
  };

  float flesh_in_teeth = 0;
  for_each_sample(skin, tools_->mouth_skin, [&](const glm::vec3& point) {
    flesh_in_teeth = std::max(flesh_in_teeth, in_teeth(point));
  });
  float tongue_in_teeth = 0;
  float in_palate = 0;
  float in_flesh = 0;
  for_each_sample(
      tools_->posed.at(HeadSurface::Tongue).positions,
      tools_->description(HeadSurface::Tongue).triangles,
      [&](const glm::vec3& point) {
        tongue_in_teeth = std::max(tongue_in_teeth, in_teeth(point));
        const auto at = frames.upper(point);
        if (under_palate(at)) {
          in_palate = std::min(in_palate, tools_->palate.signed_distance(at, FirmPart::kDeepest));
        }
        const bool is_side = std::abs(point.x) > kMidTongue;
        if (is_side && point.z > kRootEnds) {
          in_flesh = std::min(in_flesh, flesh.signed_distance(point, FirmPart::kDeepest));
        }
      });
  return {.lip_in_lip = std::max(0.0, -tools_->posed.lips.smallest_gap_mm),
          .flesh_in_teeth = static_cast<double>(flesh_in_teeth),
          .tongue_in_teeth = static_cast<double>(tongue_in_teeth),
          .tongue_in_palate = static_cast<double>(-in_palate),
          .tongue_in_flesh = static_cast<double>(-in_flesh)};
}

MouthMeasures MouthRuler::measure(const Pose& pose) {
  take(pose);
  return {.lips = lips(),
          .jaw_deg = value(tools_->pose, Control::Jaw),
          .lip_to_incisors_mm = lip_to_incisors_mm(),
          .seen = seen(),
          .tongue = tongue()};
}

}  // namespace bimodal::synth
