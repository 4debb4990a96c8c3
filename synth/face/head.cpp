#include "synth/face/head.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "synth/face/eyes.hpp"
#include "synth/face/head_files.hpp"
#include "synth/face/head_motion.hpp"
#include "synth/face/jaw.hpp"
#include "synth/face/jaw_followers.hpp"
#include "synth/face/lashes.hpp"
#include "synth/face/lids.hpp"
#include "synth/face/linear_fields.hpp"
#include "synth/face/lip_contact.hpp"
#include "synth/face/lip_measures.hpp"
#include "synth/face/lip_tuck.hpp"
#include "synth/face/lip_volume.hpp"
#include "synth/face/mouth_loops.hpp"
#include "synth/face/padded.hpp"
#include "synth/face/palate.hpp"
#include "synth/face/quad_normals.hpp"
#include "synth/face/rigid_part.hpp"
#include "synth/face/stencils.hpp"
#include "synth/face/teeth_obstacle.hpp"
#include "synth/face/tongue.hpp"
#include "synth/face/tongue_contact.hpp"

namespace bimodal::synth {

namespace {

constexpr int kSkinLevels = 2;
constexpr std::size_t kFirstPart = 3;  // of the rigid ones, after skin, tongue and lashes

template <typename Points>
void pad(const Points& points, PaddedPoints& padded_points) {
  padded_points.resize(points.size());
  std::ranges::transform(
      points, padded_points.begin(), [](const auto& point) { return padded(point); });
}

void unpad(std::span<const Padded> padded_points, std::vector<glm::vec3>& points) {
  points.resize(padded_points.size());
  std::ranges::transform(padded_points, points.begin(), unpadded);
}

std::vector<double> x_of(std::span<const glm::dvec3> points) {
  std::vector<double> result;
  for (const auto& point : points) result.push_back(point.x);
  return result;
}

/// 1 in the mouth's loops below the corner, 0 above it and elsewhere.
std::vector<double> on_lower_lip(const FieldTable& table) {
  const auto columns = table.whole_numbers("mouth_column");
  const auto rings = table.whole_numbers("mouth_ring");
  std::vector<double> lower(table.rows());
  for (std::size_t i = 0; i < lower.size(); ++i) {
    if (rings[i] < MouthLoops::kFirstRing || rings[i] > MouthLoops::kLastRing) continue;
    lower[i] = columns[i] == MouthLoops::kCorner ? 0.5 : (columns[i] > MouthLoops::kCorner ? 1 : 0);
  }
  return lower;
}

RigidPart subdivided(const Cage& cage, Material material, RigidPart::Carrier carrier, int levels) {
  return rigid_part(cage, {cage.vertices.size(), cage.faces, levels}, material, carrier);
}

/// Teeth know how far each vertex is from the biting edge.
RigidPart teeth_part(const Cage& cage,
                     RigidPart::Carrier carrier,
                     std::span<const double> heights) {
  const Stencils stencils{cage.vertices.size(), cage.faces, 2};
  auto part = rigid_part(cage, stencils, Material::Tooth, carrier);
  part.description.special = stencils.apply(heights);
  return part;
}

std::vector<RigidPart> rigid_parts(const HeadFiles& files) {
  using enum RigidPart::Carrier;
  const auto& upper = files.part("upper_teeth");
  const auto& lower = files.part("lower_teeth");
  const auto heights = files.teeth.column("height");
  std::vector<RigidPart> parts;
  parts.push_back(teeth_part(upper, UpperTeeth, heights.first(upper.vertices.size())));
  parts.push_back(teeth_part(lower, LowerTeeth, heights.last(lower.vertices.size())));
  parts.push_back(subdivided(files.part("upper_gum"), Material::Gum, UpperTeeth, 1));
  parts.push_back(subdivided(files.part("lower_gum"), Material::Gum, LowerTeeth, 1));
  parts.push_back(palate_part());
  parts.push_back(subdivided(files.part("left_ear"), Material::Skin, Head, 2));
  parts.push_back(subdivided(files.part("right_ear"), Material::Skin, Head, 2));
  for (auto& part : eye_parts(files.part("left_eye"), true)) parts.push_back(std::move(part));
  for (auto& part : eye_parts(files.part("right_eye"), false)) parts.push_back(std::move(part));
  return parts;
}

}  // namespace

/// Everything that posing needs. The surfaces are skin, tongue, lashes, then the rigid parts.
struct Head::Rig {
  explicit Rig(const HeadFiles& files)
      : rest{files.part("skin").vertices},
        jaw_followers{files.fields.column("jaw")},
        mouth{files.fields.whole_numbers("mouth_ring"),
              files.fields.whole_numbers("mouth_column"),
              x_of(rest)},
        linear{files.fields},
        tuck{files.fields, rest},
        volume{mouth, rest},
        teeth{files.fields},
        lids{files.fields, rest},
        lashes{files.fields, rest},
        skin{rest.size(), files.part("skin").faces, kSkinLevels},
        tongue{kTongueVertices, files.part("tongue").faces, kSkinLevels},
        head_weight{skin.apply(files.fields.column("neck"))},
        rest_skin{drawn(skin, rest)},
        ruler{files.fields, mouth, rest_skin},
        parts{rigid_parts(files)},
        tongue_contact{parts[0], parts[1]} {
    surfaces.push_back({.material = Material::Skin,
                        .triangles = skin.triangles(),
                        .rest_positions = rest_skin,
                        .lip = skin.apply(files.fields.column("lip")),
                        .wet = skin.apply(files.fields.column("wet")),
                        .scalp = skin.apply(files.fields.column("scalp")),
                        .lower = skin.apply(on_lower_lip(files.fields)),
                        .special = skin.apply(files.fields.column("dark")),
                        .name = "skin"});
    surfaces.push_back(unmasked(Material::Tongue, tongue.triangles(), resting_tongue()));
    surfaces.back().name = "tongue";
    surfaces.push_back(lashes.description(rest_skin));
    surfaces.back().name = "lashes";
    for (auto& part : parts) surfaces.push_back(part.description);
  }

  static std::vector<glm::vec3> drawn(const Stencils& stencils, std::span<const glm::dvec3> cage) {
    std::vector<glm::vec3> fine;
    stencils.apply(cage, fine);
    return fine;
  }

  /// The order matters: each step sees what the former ones did.
  void pose_skin_cage(const Pose& asked,
                      const JawMotion& jaw,
                      std::vector<glm::dvec3>& cage) const {
    // A lip that is held at the teeth cannot be pushed out as well.
    Pose pose = asked;
    value(pose, Control::LipProtrusion) *= 1.0 - value(asked, Control::LowerLipTuck);
    cage = rest;
    linear.move(pose, cage);
    tuck.roll(value(pose, Control::LowerLipTuck), cage);
    jaw_followers.move(jaw, cage);
    tuck.carry(value(pose, Control::LowerLipTuck), mouth, cage);
    bring_lips_together({.closure = value(pose, Control::LipClosure),
                         .compression = value(pose, Control::LipCompression),
                         .width_mm = value(pose, Control::LipWidth)},
                        mouth,
                        cage);
    volume.keep(mouth, cage);
    teeth.push_lips_out(jaw, cage);
    const double lid = value(pose, Control::LidClosure);
    lids.close(lid, std::min(1.0, lid + value(pose, Control::RightLidClosure)), cage);
  }

  [[nodiscard]] std::vector<glm::vec3> resting_tongue() const {
    PosedHead posed;
    posed.surfaces.resize(kFirstPart);
    pose_tongue(neutral_pose(), {}, posed);
    return std::move(posed.surfaces[1].positions);
  }

  /// Skin, lashes, and the lips' measures.
  void pose_skin(const Pose& pose,
                 const JawMotion& jaw,
                 const RigidMotion& head,
                 PosedHead& posed) const {
    auto& drawn = posed.surfaces[0];
    auto& blades = posed.surfaces[2];
    auto& memory = posed.memory;
    pose_skin_cage(pose, jaw, posed.skin_cage);
    pad(posed.skin_cage, memory.skin_cage);
    skin.apply(memory.skin_cage, memory.skin);
    unpad(memory.skin, drawn.positions);
    posed.lips = ruler.measure(mouth, drawn.positions);
    lashes.place(drawn.positions, blades);
    if (head != RigidMotion{}) {
      turn(head, blades);
      turn_skin(head, head_weight, memory.skin);
      unpad(memory.skin, drawn.positions);
    }
    quad_normals(memory.skin, skin.quads(), memory.skin_normals, drawn.normals);
  }

  void pose_tongue(const Pose& pose, const JawMotion& jaw, PosedHead& posed) const {
    auto& drawn = posed.surfaces[1];
    auto& memory = posed.memory;
    tongue.apply(tongue_cage(pose, jaw), drawn.positions);
    tongue_contact.yield_to(jaw, teeth_offset(pose), drawn.positions);
    pad(drawn.positions, memory.tongue);
    quad_normals(memory.tongue, tongue.quads(), memory.tongue_normals, drawn.normals);
  }

  /// Those of which `posed` already has another pose are left where they stay.
  void move_parts(const Pose& pose,
                  const JawMotion& jaw,
                  const RigidMotion& head,
                  PosedHead& posed) const {
    auto& memory = posed.memory;
    memory.motions.resize(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto motion = head.after(carried(parts[i].carrier, pose, jaw));
      if (memory.posed_by.get() == this && memory.motions[i] == motion) continue;
      parts[i].move(motion, posed.surfaces[i + kFirstPart]);
      memory.motions[i] = motion;
    }
  }

  [[nodiscard]] static glm::dvec3 teeth_offset(const Pose& pose) {
    return {value(pose, Control::TeethX), 0.0, value(pose, Control::TeethZ)};
  }

  [[nodiscard]] static RigidMotion carried(RigidPart::Carrier carrier,
                                           const Pose& pose,
                                           const JawMotion& jaw) {
    const double gaze_x = value(pose, Control::GazeX);
    const double gaze_y = value(pose, Control::GazeY);
    const RigidMotion offset{.translation = teeth_offset(pose)};
    switch (carrier) {
      case RigidPart::Carrier::Head:
        return {};
      case RigidPart::Carrier::UpperTeeth:
        return offset;
      case RigidPart::Carrier::LowerTeeth:
        return offset.after(jaw.rigid());
      case RigidPart::Carrier::LeftEye:
        return gaze(true, gaze_x, gaze_y);
      case RigidPart::Carrier::RightEye:
        return gaze(false, gaze_x, gaze_y);
    }
    return {};
  }

  std::vector<glm::dvec3> rest;
  JawFollowers jaw_followers;
  MouthLoops mouth;
  LinearFields linear;
  LipTuck tuck;
  LipVolume volume;
  TeethObstacle teeth;
  Lids lids;
  Lashes lashes;
  Stencils skin;
  Stencils tongue;
  std::vector<float> head_weight;
  std::vector<glm::vec3> rest_skin;
  LipRuler ruler;
  std::vector<RigidPart> parts;  ///< the upper teeth, the lower, the others
  TongueContact tongue_contact;
  std::vector<SurfaceDescription> surfaces;
};

Head::Head(const std::filesystem::path& folder)
    : rig_{std::make_shared<const Rig>(HeadFiles{folder})} {}

Head::~Head() = default;
Head::Head(Head&& other) noexcept = default;
Head& Head::operator=(Head&& other) noexcept = default;

std::span<const SurfaceDescription> Head::surfaces() const {
  return rig_->surfaces;
}

void Head::pose(const Pose& wanted, PosedHead& posed) const {
  const Pose pose = within_range(wanted);
  const JawMotion jaw{.opening_deg = value(pose, Control::Jaw),
                      .thrust_mm = value(pose, Control::JawThrust)};
  const auto head = head_motion(pose);

  posed.surfaces.resize(rig_->surfaces.size());
  rig_->pose_skin(pose, jaw, head, posed);
  rig_->pose_tongue(pose, jaw, posed);
  if (head != RigidMotion{}) turn(head, posed.surfaces[1]);
  rig_->move_parts(pose, jaw, head, posed);
  posed.lips.inner_centre = glm::vec3{head.move(glm::dvec3{posed.lips.inner_centre})};
  if (posed.memory.posed_by != rig_) posed.memory.posed_by = rig_;
}

}  // namespace bimodal::synth
