#include "synth/render/surface_renderer.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/color_space.hpp>

#include "stimuli/base/error.hpp"
#include "synth/render/camera.hpp"
#include "synth/render/cut_faces.hpp"
#include "synth/render/light_points.hpp"
#include "synth/render/mesh_buffers.hpp"
#include "synth/render/occlusion.hpp"
#include "synth/render/paint.hpp"
#include "synth/render/part_programs.hpp"
#include "synth/render/picture_target.hpp"
#include "synth/render/shader.hpp"
#include "synth/render/shadow_map.hpp"

namespace bimodal::synth {

namespace {

std::vector<std::vector<VertexPaint>> paint_all(std::span<const SurfaceDescription> surfaces,
                                                const Materials& materials) {
  std::vector<std::vector<VertexPaint>> paints;
  paints.reserve(surfaces.size());
  for (const SurfaceDescription& surface : surfaces) paints.push_back(paint(surface, materials));
  return paints;
}

glm::vec3 linear(const Colour& colour) {
  return glm::convertSRGBToLinear(glm::vec3{colour[0], colour[1], colour[2]} / 255.0F);
}

/// 0 outside, 1 for all that only light through the lips reaches.
float inside_mouth(const SurfaceDescription& surface, std::size_t vertex) {
  switch (surface.material) {
    case Material::Tooth:
    case Material::Gum:
    case Material::Tongue:
      return 1.0F;
    case Material::Skin:
      break;
    default:
      return 0.0F;
  }
  constexpr float kFullestLip = 1.0F;    // lip mask where the lips are thickest
  constexpr float kContactStrip = 2.6F;  // where they touch each other
  return glm::clamp(
      (surface.lip[vertex] - kFullestLip) / (kContactStrip - kFullestLip), 0.0F, 1.0F);
}

std::vector<FixedVertex> fixed_vertices(std::span<const SurfaceDescription> surfaces,
                                        std::span<const std::vector<VertexPaint>> paints,
                                        std::span<const DrawnVertex> drawn,
                                        std::span<const Exposure> exposures) {
  std::vector<FixedVertex> vertices;
  vertices.reserve(drawn.size());
  const auto mask = [](const std::vector<float>& values, std::size_t i) {
    return values.empty() ? 0.0F : values[i];
  };
  for (const auto& [s, i] : drawn) {
    const SurfaceDescription& surface = surfaces[s];
    const VertexPaint& paint = paints[s][i];
    const Exposure& exposure = exposures[vertices.size()];
    vertices.push_back({surface.rest_positions[i],
                        paint.albedo,
                        {exposure.sky, exposure.key, exposure.fill, inside_mouth(surface, i)},
                        {mask(surface.lip, i),
                         mask(surface.wet, i),
                         mask(surface.scalp, i),
                         mask(surface.special, i)},
                        paint.brow,
                        paint.gloss});
  }
  return vertices;
}

/// Whether the head is turned by at most 12 degrees from straight ahead.
bool looks_ahead(const glm::mat3& head_axes) {
  constexpr float kCosine = 0.978F;
  const float cosine_of_turn = 0.5F * (head_axes[0].x + head_axes[1].y + head_axes[2].z - 1.0F);
  return cosine_of_turn > kCosine;
}

void check_for_errors(const char* deed) {
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    throw Error{fmt::format("cannot {}: OpenGL error 0x{:04x}", deed, error)};
  }
}

}  // namespace

struct SurfaceRenderer::Stage {
  Stage(std::span<const SurfaceDescription> surfaces,
        const PosedHead& resting,
        const View& view,
        const Appearance& wanted);

  void draw_head(const PosedHead& posed, const glm::mat3& head_axes);

 private:
  using Parts = std::initializer_list<HeadPart>;
  static constexpr Parts kOuterSkin{
      HeadPart::Skin, HeadPart::Ear, HeadPart::Lips, HeadPart::Brow, HeadPart::Hair};
  static constexpr Parts kMouth{HeadPart::UpperTooth,
                                HeadPart::LowerTooth,
                                HeadPart::Gum,
                                HeadPart::Palate,
                                HeadPart::Tongue};

  void draw_parts(Parts parts) const;
  void draw_opaque(bool mouth_is_open) const;
  void draw_skin_over_the_rest() const;
  void draw_backdrop() const;
  void draw_clear_parts() const;

  Appearance appearance_;
  std::vector<std::vector<VertexPaint>> paints_;
  DrawnMesh drawn_;
  MeshBuffers mesh_;
  ShadowMap shadow_map_;
  PartPrograms programs_;
  Program backdrop_;
  std::optional<CutFaces> cut_faces_;
  std::optional<LightPoints> points_;
  MeshBuffers::Side side_ = MeshBuffers::Side::Both;

 public:
  PictureTarget target;
};

SurfaceRenderer::Stage::Stage(std::span<const SurfaceDescription> surfaces,
                              const PosedHead& resting,
                              const View& view,
                              const Appearance& wanted)
    : appearance_{wanted},
      paints_{paint_all(surfaces, wanted.materials)},
      drawn_{drawn_mesh(surfaces, paints_, resting, towards_camera(view), wanted.quality)},
      mesh_{drawn_},
      shadow_map_{wanted.materials.key_direction},
      programs_{wanted, camera_for(view), shadow_map_.map_from_world()},
      backdrop_{ShaderSource{{"backdrop.vert"}, {"backdrop.frag"}}},
      target{view.width, view.height, wanted.samples} {
  const Materials& materials = wanted.materials;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_CULL_FACE);
  mesh_.move_to(resting);
  const std::vector<Exposure> exposures = exposure_at_rest(resting, mesh_, drawn_, materials);
  mesh_.fix(fixed_vertices(surfaces, paints_, drawn_.vertices, exposures));

  const Camera camera = camera_for(view);
  if (wanted.cut) {
    cut_faces_.emplace(surfaces, *wanted.cut, materials, wanted.shown, camera.clip_from_world);
  }
  if (wanted.points != Points::None) points_.emplace(surfaces, wanted, view, camera);
  const Backdrop backdrop = view.backdrop.value_or(materials.backdrop);
  backdrop_.use();
  backdrop_.set("centre_colour", linear(backdrop.centre));
  backdrop_.set("edge_colour", linear(backdrop.edge));
  target.begin_ground();
  draw_backdrop();
  check_for_errors("prepare the head for drawing");
}

void SurfaceRenderer::Stage::draw_parts(Parts parts) const {
  for (const HeadPart part : parts) {
    if (!programs_.draws(part)) continue;
    programs_.use(part);
    mesh_.draw(part, side_);
  }
}

void SurfaceRenderer::Stage::draw_opaque(bool mouth_is_open) const {
  draw_parts(kOuterSkin);
  draw_parts({HeadPart::Eye});
  if (mouth_is_open) {
    draw_parts({HeadPart::MouthWall});
    draw_parts(kMouth);
  }
}

/// The skin's nearest layer alone is mixed with what stands behind it, which must be drawn already:
/// first only its depth is drawn, then the colour of what is as near as that. So no order of the
/// triangles matters, and the far cheek and the inner side of the near one do not cloud the mouth.
void SurfaceRenderer::Stage::draw_skin_over_the_rest() const {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_parts(kOuterSkin);
  draw_parts({HeadPart::MouthWall});
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_BLEND);
  glBlendColor(0.0F, 0.0F, 0.0F, static_cast<float>(1.0 - appearance_.skin_transparency));
  glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
  draw_parts(kOuterSkin);
  draw_parts({HeadPart::MouthWall});
  glDisable(GL_BLEND);
}

void SurfaceRenderer::Stage::draw_backdrop() const {
  glDisable(GL_CULL_FACE);
  backdrop_.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_CULL_FACE);
}

void SurfaceRenderer::Stage::draw_clear_parts() const {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_CULL_FACE);
  draw_parts({HeadPart::Lash});
  glEnable(GL_CULL_FACE);
  draw_parts({HeadPart::Cornea});
  glDisable(GL_BLEND);
}

void SurfaceRenderer::Stage::draw_head(const PosedHead& posed, const glm::mat3& head_axes) {
  mesh_.move_to(posed);
  if (appearance_.quality == Quality::Full) shadow_map_.draw(mesh_, programs_.casters());
  target.begin();
  programs_.follow(posed.lips, head_axes);
  side_ = looks_ahead(head_axes) ? MeshBuffers::Side::Near : MeshBuffers::Side::Both;
  const bool mouth_is_open = posed.lips.inner_area_mm2 > 0.0 || shows_inside(appearance_);
  glFrontFace(GL_CW);  // the camera's y axis points down
  if (appearance_.cut) glEnable(GL_CLIP_DISTANCE0);
  if (points_) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw_opaque(mouth_is_open);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    points_->draw(posed);
  } else if (appearance_.skin_transparency > 0.0) {
    draw_parts(kMouth);
    if (cut_faces_) cut_faces_->draw(posed);
    draw_skin_over_the_rest();
    draw_parts({HeadPart::Eye});  // between the lids only: eyeballs behind skin distract
    draw_clear_parts();
  } else {
    draw_opaque(mouth_is_open);
    if (cut_faces_) cut_faces_->draw(posed);
    draw_clear_parts();
  }
  glDisable(GL_CLIP_DISTANCE0);
  glFrontFace(GL_CCW);
}

SurfaceRenderer::SurfaceRenderer(std::span<const SurfaceDescription> surfaces,
                                 const PosedHead& resting,
                                 const View& view,
                                 const Appearance& appearance) {
  const EglContext::Current current{context_};
  stage_ = std::make_unique<Stage>(surfaces, resting, view, appearance);
}

SurfaceRenderer::~SurfaceRenderer() = default;

void SurfaceRenderer::draw(const PosedHead& posed, const glm::mat3& head_axes, Image& image) {
  const EglContext::Current current{context_};
  stage_->draw_head(posed, head_axes);
  stage_->target.read_into(image);
}

std::string SurfaceRenderer::description() const {
  const EglContext::Current current{context_};
  const auto text = [](GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); };
  return fmt::format("{}, OpenGL {}", text(GL_RENDERER), text(GL_VERSION));
}

}  // namespace bimodal::synth
