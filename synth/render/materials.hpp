#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "stimuli/base/diagnostic.hpp"
#include "stimuli/picture/drawing.hpp"
#include "synth/render/backdrop.hpp"
#include "synth/render/shading.hpp"

namespace bimodal::synth {

/// Colours (8-bit sRGB) and light of the head: all that may differ between two pictures of the same
/// shape. The defaults are the natural look; synth/assets/materials/README.md says what each means
/// and what it may be.
struct Materials {
  Backdrop backdrop;
  Shading shading = Shading::Smooth;

  Colour skin{226, 178, 150};
  Colour blush{214, 128, 108};
  Colour sockets{182, 122, 108};
  Colour nostrils{70, 24, 20};
  Colour lips_outer{196, 120, 110};
  Colour lips_inner{166, 82, 77};
  Colour lips_inside{164, 74, 72};
  Colour mouth_walls{134, 58, 56};
  Colour enamel{242, 236, 220};
  Colour teeth_necks{214, 190, 150};
  Colour gums{188, 102, 98};
  Colour tongue{214, 124, 118};
  Colour palate{188, 102, 98};
  Colour brows{62, 43, 33};
  Colour hair{66, 47, 36};
  Colour lashes{38, 28, 24};
  Colour eye_white{222, 212, 204};
  Colour eye_corners{232, 224, 216};
  Colour eye_flesh{222, 160, 148};
  Colour eye_veins{214, 150, 138};
  Colour iris_dark{74, 104, 116};
  Colour iris_light{138, 160, 160};
  Colour iris_middle{148, 116, 70};
  Colour iris_edge{28, 36, 44};
  Colour pupil{8, 7, 8};
  Colour cut_skin{214, 170, 160};
  Colour cut_teeth{236, 228, 206};
  Colour cut_gums{176, 96, 92};
  Colour cut_tongue{196, 92, 96};
  Colour cut_outline{40, 20, 20};
  Colour points{240, 240, 240};

  glm::vec3 key_direction{-0.3945F, 0.4109F, 0.8219F};
  glm::vec3 key{2.15F, 2.03F, 1.90F};
  glm::vec3 fill_direction{0.6836F, 0.0965F, 0.7238F};
  glm::vec3 fill{0.68F, 0.64F, 0.62F};  // warm: a blue fill makes hollows look dirty
  glm::vec3 rim{0.55F, 0.60F, 0.70F};
  glm::vec3 sky{0.72F, 0.69F, 0.67F};
  glm::vec3 ground{0.27F, 0.20F, 0.17F};

  float exposure = 0.62F;
  float mouth_light = 0.0F;
  float texture = 1.0F;
  float gloss = 1.0F;

  /// Reads a file of synth/assets/materials' form; what it leaves out stays natural. Throws Error
  /// with all that is wrong with it.
  [[nodiscard]] static Materials read(const std::filesystem::path& file);

  /// The same from a text; absent if there are mistakes, which are added to `diagnostics`.
  [[nodiscard]] static std::optional<Materials> parse(std::string_view text,
                                                      std::string_view file,
                                                      std::vector<Diagnostic>& diagnostics);

  /// Of a preset that ships ("clay"), or of a file ("mine.json"). Throws Error, naming the presets,
  /// if it is neither.
  [[nodiscard]] static Materials named(const std::string& name_or_file);

  bool operator==(const Materials&) const = default;
};

/// All of it as constants for shaders: colours 0..255, the rest as it is.
[[nodiscard]] std::string shader_constants(const Materials& materials);

}  // namespace bimodal::synth
