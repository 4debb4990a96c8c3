#include "synth/render/occlusion.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>

#include "synth/render/shader.hpp"

namespace bimodal::synth {

namespace {

constexpr int kSkyDirections = 48;
constexpr int kSkyMapSize = 320;       // texels; 1.2 mm each
constexpr int kLightMapSize = 1024;    // 0.36 mm
constexpr float kHalfExtent = 185.0F;  // mm seen from the centre
constexpr glm::vec3 kCentre{0.0F, -20.0F, 10.0F};
constexpr float kGoldenAngle = 2.39996323F;  // radians; spreads points evenly round a sphere

struct Place {
  glm::vec3 position;
  glm::vec3 normal;

  [[nodiscard]] glm::vec3 lifted(float lift) const { return position + lift * normal; }
};

/// Of every drawn vertex.
std::vector<Place> places_of(const DrawnMesh& drawn, const PosedHead& resting) {
  std::vector<Place> places;
  places.reserve(drawn.vertices.size());
  for (const auto& [surface, own] : drawn.vertices) {
    const SurfaceGeometry& geometry = resting.surfaces[surface];
    places.push_back({geometry.positions[own], geometry.normals[own]});
  }
  return places;
}

/// The head's nearest depth, seen from infinitely far in one direction.
class DepthMaps {
 public:
  DepthMaps(const MeshBuffers& mesh, int size)
      : mesh_{mesh},
        program_{{{"depth.vert"}, {"depth.frag"}}},
        size_{size},
        depths_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {
    glGenRenderbuffers(1, &renderbuffer_);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, size, size);
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, renderbuffer_);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  }

  ~DepthMaps() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &renderbuffer_);
  }

  DepthMaps(const DepthMaps&) = delete;
  DepthMaps& operator=(const DepthMaps&) = delete;
  DepthMaps(DepthMaps&&) = delete;
  DepthMaps& operator=(DepthMaps&&) = delete;

  /// Begins to draw a map; `towards` is a unit vector. The one before can be used meanwhile.
  void draw_from(glm::vec3 towards) {
    const glm::vec3 up =
        std::abs(towards.y) > 0.95F ? glm::vec3{0.0F, 0.0F, 1.0F} : glm::vec3{0.0F, 1.0F, 0.0F};
    const glm::mat4 light_from_world = glm::lookAt(kCentre + kHalfExtent * towards, kCentre, up);
    clip_of_next_ =
        glm::ortho(-kHalfExtent, kHalfExtent, -kHalfExtent, kHalfExtent, 0.0F, 2.0F * kHalfExtent) *
        light_from_world;
    glViewport(0, 0, size_, size_);
    glClear(GL_DEPTH_BUFFER_BIT);
    program_.use();
    program_.set("clip_from_world", clip_of_next_);
    for (const HeadPart part : kCasters) mesh_.draw(part, MeshBuffers::Side::Both);
    glFlush();
  }

  /// Waits for the map that was begun; from now on it is the one that is used.
  void take() {
    glReadPixels(0, 0, size_, size_, GL_DEPTH_COMPONENT, GL_FLOAT, depths_.data());
    clip_from_world_ = clip_of_next_;
  }

  /// 0..1, the weighted part of the four nearest texels that nothing nearer covers.
  [[nodiscard]] float visible(glm::vec3 point, float bias) const {
    const glm::vec3 in_map = (glm::vec3{clip_from_world_ * glm::vec4{point, 1.0F}} * 0.5F + 0.5F) *
                             glm::vec3{static_cast<float>(size_), static_cast<float>(size_), 1.0F};
    const float depth = in_map.z - bias / (2.0F * kHalfExtent);
    const int column = static_cast<int>(in_map.x + 0.5F) - 1;  // rounded down, as it is positive
    const int row = static_cast<int>(in_map.y + 0.5F) - 1;
    const float x = in_map.x - 0.5F - static_cast<float>(column);
    const float y = in_map.y - 0.5F - static_cast<float>(row);
    return (1.0F - y) * ((1.0F - x) * open(column, row, depth) + x * open(column + 1, row, depth)) +
           y * ((1.0F - x) * open(column, row + 1, depth) + x * open(column + 1, row + 1, depth));
  }

 private:
  // Lashes are too fine, the cornea is clear, and what is in the shut mouth is covered by the rest.
  static constexpr std::array kCasters{HeadPart::Skin,
                                       HeadPart::Ear,
                                       HeadPart::Lips,
                                       HeadPart::Brow,
                                       HeadPart::Hair,
                                       HeadPart::Eye,
                                       HeadPart::MouthWall};

  [[nodiscard]] float open(int column, int row, float depth) const {
    if (column < 0 || row < 0 || column >= size_ || row >= size_) return 1.0F;
    const auto texel = static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) +
                       static_cast<std::size_t>(column);
    return depth < depths_[texel] ? 1.0F : 0.0F;
  }

  const MeshBuffers& mesh_;
  Program program_;
  int size_;
  std::vector<float> depths_;
  GLuint renderbuffer_ = 0;
  GLuint framebuffer_ = 0;
  glm::mat4 clip_from_world_{1.0F};
  glm::mat4 clip_of_next_{1.0F};
};

/// Evenly over the sky but its lowest eighth, which the shoulders hide.
glm::vec3 sky_direction(int number) {
  const float part = (static_cast<float>(number) + 0.5F) / static_cast<float>(kSkyDirections);
  const float height = 1.0F - 1.75F * part;
  const float radius = std::sqrt(std::max(0.0F, 1.0F - height * height));
  const float round = static_cast<float>(number) * kGoldenAngle;
  return {radius * std::cos(round), height, radius * std::sin(round)};
}

void bake_sky(std::span<const Place> places,
              const MeshBuffers& mesh,
              std::vector<Exposure>& baked) {
  constexpr float kLift = 0.6F;  // mm off the surface, against shadowing itself
  constexpr float kBias = 1.6F;  // mm
  std::vector<float> arriving(baked.size());
  std::vector<float> possible(baked.size());
  DepthMaps maps{mesh, kSkyMapSize};
  maps.draw_from(sky_direction(0));
  for (int i = 0; i < kSkyDirections; ++i) {
    const glm::vec3 towards = sky_direction(i);
    maps.take();
    if (i + 1 < kSkyDirections) maps.draw_from(sky_direction(i + 1));
    const float brightness = std::max(0.04F, 0.42F + 0.58F * towards.y);
    for (std::size_t v = 0; v < places.size(); ++v) {
      const float cosine = glm::dot(places[v].normal, towards);
      if (cosine <= 0.0F) continue;
      possible[v] += cosine * brightness;
      arriving[v] += cosine * brightness * maps.visible(places[v].lifted(kLift), kBias);
    }
  }
  for (std::size_t v = 0; v < baked.size(); ++v) {
    baked[v].sky = possible[v] > 0.0F ? arriving[v] / possible[v] : 0.0F;
  }
}

/// The part of a light of some size that arrives: a mean over 5 x 5 points round the vertex, in the
/// plane across the light.
void bake_light(std::span<const Place> places,
                DepthMaps& maps,
                glm::vec3 towards,
                float spread_mm,
                float Exposure::*arriving,
                std::vector<Exposure>& baked) {
  constexpr float kLift = 0.8F;  // mm
  constexpr float kBias = 1.2F;  // mm
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3{0.0F, 1.0F, 0.0F}, towards));
  const glm::vec3 up = glm::cross(towards, right);
  maps.draw_from(towards);
  maps.take();
  for (std::size_t v = 0; v < places.size(); ++v) {
    float sum = 0.0F;
    for (int row = -2; row <= 2; ++row) {
      for (int column = -2; column <= 2; ++column) {
        const glm::vec3 off =
            0.5F * spread_mm * (static_cast<float>(column) * right + static_cast<float>(row) * up);
        sum += maps.visible(places[v].lifted(kLift) + off, kBias);
      }
    }
    baked[v].*arriving = sum / 25.0F;
  }
}

/// Each vertex moves half the way to the mean of its neighbours, some times.
void spread_shadows(std::span<const std::uint32_t> triangles, std::vector<Exposure>& baked) {
  constexpr int kTimes = 3;

  struct Sum {
    float key = 0.0F;
    float fill = 0.0F;
    float count = 0.0F;
  };

  std::vector<Sum> sums(baked.size());
  for (int time = 0; time < kTimes; ++time) {
    std::ranges::fill(sums, Sum{});
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
      const Exposure& neighbour = baked[triangles[next]];
      Sum& sum = sums[triangles[i]];
      sum.key += neighbour.key;
      sum.fill += neighbour.fill;
      sum.count += 1.0F;
    }
    for (std::size_t v = 0; v < baked.size(); ++v) {
      if (sums[v].count == 0.0F) continue;
      baked[v].key = 0.5F * (baked[v].key + sums[v].key / sums[v].count);
      baked[v].fill = 0.5F * (baked[v].fill + sums[v].fill / sums[v].count);
    }
  }
}

}  // namespace

std::vector<Exposure> exposure_at_rest(const PosedHead& resting,
                                       const MeshBuffers& mesh,
                                       const DrawnMesh& drawn,
                                       const Materials& materials) {
  const std::vector<Place> places = places_of(drawn, resting);
  std::vector<Exposure> baked(places.size());
  bake_sky(places, mesh, baked);
  DepthMaps maps{mesh, kLightMapSize};
  bake_light(places, maps, materials.key_direction, 1.6F, &Exposure::key, baked);
  bake_light(places, maps, materials.fill_direction, 2.5F, &Exposure::fill, baked);
  std::vector<std::uint32_t> triangles;
  for (const HeadPart part : {HeadPart::Skin, HeadPart::Ear}) {
    const PartTriangles& own = drawn.parts.at(static_cast<std::size_t>(part));
    triangles.insert(triangles.end(), own.near.begin(), own.near.end());
    triangles.insert(triangles.end(), own.far.begin(), own.far.end());
  }
  spread_shadows(triangles, baked);
  return baked;
}

}  // namespace bimodal::synth
