#include "synth/render/surface_renderer.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/gtc/color_space.hpp>

#include "stimuli/base/error.hpp"
#include "synth/render/camera.hpp"
#include "synth/render/lights.hpp"
#include "synth/render/mesh_buffers.hpp"
#include "synth/render/occlusion.hpp"
#include "synth/render/paint.hpp"
#include "synth/render/picture_target.hpp"
#include "synth/render/shader.hpp"

namespace bimodal::synth {

namespace {

std::vector<std::vector<VertexPaint>> paint_all(std::span<const SurfaceDescription> surfaces) {
  std::vector<std::vector<VertexPaint>> paints;
  std::array<PartTriangles, kHeadPartCount> triangles;
  paints.reserve(surfaces.size());
  std::ranges::transform(surfaces, std::back_inserter(paints), paint);
  return paints;
}

std::vector<Program> compile_parts() {
  std::vector<Program> programs;
  programs.reserve(kHeadPartCount);
  for (const PartLook& look : part_looks()) {
    programs.emplace_back(
        ShaderSource{{"head.vert"}, {"noise.glsl", "surface.glsl", look.shader}, look.definition});
  }
  return programs;
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
                                        std::span<const Exposure> exposures) {
  std::vector<FixedVertex> vertices;
  vertices.reserve(exposures.size());
  const auto mask = [](const std::vector<float>& values, std::size_t i) {
    return values.empty() ? 0.0F : values[i];
  };
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const SurfaceDescription& surface = surfaces[s];
    for (std::size_t i = 0; i < surface.rest_positions.size(); ++i) {
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
  Stage(std::span<const SurfaceDescription> surfaces, const PosedHead& resting, const View& view);

  void draw_head(const PosedHead& posed, const glm::mat3& head_axes) const;

  std::vector<std::vector<VertexPaint>> paints;
  std::array<PartTriangles, kHeadPartCount> triangles;
  MeshBuffers mesh;
  std::vector<Program> programs;  // one per HeadPart
  Program backdrop;
  PictureTarget target;
};

SurfaceRenderer::Stage::Stage(std::span<const SurfaceDescription> surfaces,
                              const PosedHead& resting,
                              const View& view)
    : paints{paint_all(surfaces)},
      triangles{sort_by_part(surfaces, paints, resting, towards_camera(view))},
      mesh{surfaces, triangles},
      programs{compile_parts()},
      backdrop{ShaderSource{{"backdrop.vert"}, {"backdrop.frag"}}},
      target{view.width, view.height} {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_CULL_FACE);
  mesh.move_to(resting);
  const std::vector<Exposure> exposures = exposure_at_rest(resting, mesh, triangles);
  mesh.fix(fixed_vertices(surfaces, paints, exposures));

  const Camera camera = camera_for(view);
  for (const PartLook& look : part_looks()) {
    const Program& program = programs.at(static_cast<std::size_t>(look.part));
    program.use();
    program.set("clip_from_world", camera.clip_from_world);
    program.set("camera", camera.position);
    program.set("key_direction", kKeyDirection);
    program.set("fill_direction", kFillDirection);
    program.set("sky_floor", look.sky_floor);
    program.set("shadow_floor", look.shadow_floor);
    program.set("softness", look.softness);
    program.set("exponent", look.exponent);
    program.set("grain", look.grain);
  }
  backdrop.use();
  backdrop.set("centre_colour", linear(view.backdrop.centre));
  backdrop.set("edge_colour", linear(view.backdrop.edge));
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  check_for_errors("prepare the head for drawing");
}

void SurfaceRenderer::Stage::draw_head(const PosedHead& posed, const glm::mat3& head_axes) const {
  const LipMeasures& lips = posed.lips;
  const glm::vec3 opening{
      0.5 * lips.inner_width_mm, 0.5 * lips.inner_height_mm, lips.inner_area_mm2};
  const auto side = looks_ahead(head_axes) ? MeshBuffers::Side::Near : MeshBuffers::Side::Both;
  const auto draw_part = [&](HeadPart part) {
    const Program& program = programs.at(static_cast<std::size_t>(part));
    program.use();
    program.set("head_axes", head_axes);
    program.set("mouth_centre", lips.inner_centre);
    program.set("mouth_opening", opening);
    mesh.draw(part, side);
  };
  using enum HeadPart;
  mesh.move_to(posed);
  glFrontFace(GL_CW);  // the camera's y axis points down
  for (const HeadPart part : {Skin, Lips, Brow, Hair, Eye}) draw_part(part);
  if (lips.inner_area_mm2 > 0.0) {
    for (const HeadPart part : {MouthWall, Tooth, Gum, Tongue}) draw_part(part);
  }
  glDisable(GL_CULL_FACE);
  backdrop.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_BLEND);
  draw_part(Lash);
  glEnable(GL_CULL_FACE);
  draw_part(Cornea);
  glDisable(GL_BLEND);
  glFrontFace(GL_CCW);
}

SurfaceRenderer::SurfaceRenderer(std::span<const SurfaceDescription> surfaces,
                                 const PosedHead& resting,
                                 const View& view) {
  const EglContext::Current current{context_};
  stage_ = std::make_unique<Stage>(surfaces, resting, view);
}

SurfaceRenderer::~SurfaceRenderer() = default;

void SurfaceRenderer::draw(const PosedHead& posed, const glm::mat3& head_axes, Image& image) {
  const EglContext::Current current{context_};
  stage_->target.begin();
  stage_->draw_head(posed, head_axes);
  stage_->target.read_into(image);
}

std::string SurfaceRenderer::description() const {
  const EglContext::Current current{context_};
  const auto text = [](GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); };
  return fmt::format("{}, OpenGL {}", text(GL_RENDERER), text(GL_VERSION));
}

}  // namespace bimodal::synth
