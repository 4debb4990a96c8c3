#include "synth/render/material_rows.hpp"

#include <array>

namespace bimodal::synth {

namespace {

using M = Materials;

constexpr std::array kColours{
    ColourRow{"skin", "colour", &M::skin, "kSkin"},
    ColourRow{"skin", "blush", &M::blush, "kBlush"},
    ColourRow{"skin", "sockets", &M::sockets, "kSockets"},
    ColourRow{"skin", "nostrils", &M::nostrils, "kNostrils"},
    ColourRow{"lips", "outer", &M::lips_outer, "kLipsOuter"},
    ColourRow{"lips", "inner", &M::lips_inner, "kLipsInner"},
    ColourRow{"lips", "inside", &M::lips_inside, "kLipsInside"},
    ColourRow{"mouth", "walls", &M::mouth_walls, "kMouthWalls"},
    ColourRow{"mouth", "gums", &M::gums, "kGums"},
    ColourRow{"mouth", "tongue", &M::tongue, "kTongue"},
    ColourRow{"mouth", "palate", &M::palate, "kPalate"},
    ColourRow{"teeth", "enamel", &M::enamel, "kEnamel"},
    ColourRow{"teeth", "necks", &M::teeth_necks, "kTeethNecks"},
    ColourRow{"hair", "brows", &M::brows, "kBrows"},
    ColourRow{"hair", "scalp", &M::hair, "kHair"},
    ColourRow{"hair", "lashes", &M::lashes, "kLashes"},
    ColourRow{"eyes", "white", &M::eye_white, "kEyeWhite"},
    ColourRow{"eyes", "corners", &M::eye_corners, "kEyeCorners"},
    ColourRow{"eyes", "flesh", &M::eye_flesh, "kEyeFlesh"},
    ColourRow{"eyes", "veins", &M::eye_veins, "kEyeVeins"},
    ColourRow{"eyes", "iris_dark", &M::iris_dark, "kIrisDark"},
    ColourRow{"eyes", "iris_light", &M::iris_light, "kIrisLight"},
    ColourRow{"eyes", "iris_middle", &M::iris_middle, "kIrisMiddle"},
    ColourRow{"eyes", "iris_edge", &M::iris_edge, "kIrisEdge"},
    ColourRow{"eyes", "pupil", &M::pupil, "kPupilColour"},
    ColourRow{"cut", "skin", &M::cut_skin, "kCutSkin"},
    ColourRow{"cut", "teeth", &M::cut_teeth, "kCutTeeth"},
    ColourRow{"cut", "gums", &M::cut_gums, "kCutGums"},
    ColourRow{"cut", "tongue", &M::cut_tongue, "kCutTongue"},
    ColourRow{"cut", "outline", &M::cut_outline, "kCutOutline"},
    ColourRow{"points", "colour", &M::points, "kPoints"},
};

constexpr std::array kLights{
    LightRow{"key_direction", &M::key_direction, true, "kKeyDirection"},
    LightRow{"key", &M::key, false, "kKeyColour"},
    LightRow{"fill_direction", &M::fill_direction, true, "kFillDirection"},
    LightRow{"fill", &M::fill, false, "kFillColour"},
    LightRow{"rim", &M::rim, false, "kRimColour"},
    LightRow{"sky", &M::sky, false, "kSkyColour"},
    LightRow{"ground", &M::ground, false, "kGroundColour"},
};

constexpr std::array kAmounts{
    AmountRow{
        "light", "exposure", &M::exposure, 0.05, 5, "how bright it all is, e.g. 0.62", "kExposure"},
    AmountRow{"light",
              "mouth",
              &M::mouth_light,
              0,
              1,
              "how far the mouth is lit as if there were no lips, 0 to 1",
              "kMouthLight"},
    AmountRow{"surface",
              "texture",
              &M::texture,
              0,
              1,
              "how much the colours vary from place to place, 0 to 1",
              "kTexture"},
    AmountRow{"surface", "gloss", &M::gloss, 0, 4, "how strong highlights are, e.g. 1", "kGloss"},
};

}  // namespace

std::span<const ColourRow> colour_rows() {
  return kColours;
}

std::span<const LightRow> light_rows() {
  return kLights;
}

std::span<const AmountRow> amount_rows() {
  return kAmounts;
}

}  // namespace bimodal::synth
