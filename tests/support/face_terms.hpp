#pragma once

#include "protocols/model/face_terms.hpp"

namespace bimodal::protocols {

/// What the face that ships can be asked for, written down once more, so that protocols can be
/// tested without it; runner_tests hold it to what the runner tells, and protocols_tests to the
/// schema.
[[nodiscard]] inline FaceTerms known_face_terms() {
  return {
      .views = {"front", "threequarter", "side", "mouth"},
      .points = {"none", "sparse", "lips", "all"},
      .materials = {"clay", "dark-skin", "high-contrast", "natural", "paper-1993", "point-light"},
      .parts = {{"skin", 0x1},
                {"ears", 0x2},
                {"lips", 0x4},
                {"brows", 0x8},
                {"hair", 0x10},
                {"eyes", 0x3020},
                {"mouth_walls", 0x40},
                {"teeth", 0x180},
                {"upper_teeth", 0x80},
                {"lower_teeth", 0x100},
                {"gums", 0x200},
                {"palate", 0x400},
                {"tongue", 0x800}},
      .expressions =
          {{"smile", {{"lid_closure", 0.14}, {"brow_raise", 0.6}}},
           {"surprise", {{"brow_raise", 7}, {"lid_closure", -0.22}}},
           {"sadness",
            {{"brow_raise", 2}, {"lid_closure", 0.22}, {"head_pitch", 5}, {"gaze_y", 5}}},
           {"anger", {{"brow_raise", -3.6}, {"lid_closure", 0.08}}},
           {"disgust", {{"brow_raise", -2.5}, {"lid_closure", 0.2}}},
           {"fear", {{"brow_raise", 5}, {"lid_closure", -0.25}}}},
      .controls = {{"teeth_x", "mm", -4, 4},
                   {"teeth_z", "mm", -3, 3},
                   {"lid_closure", "ratio", -0.25, 1},
                   {"right_lid_closure", "ratio", 0, 1},
                   {"brow_raise", "mm", -4, 9},
                   {"head_yaw", "deg", -60, 60},
                   {"head_pitch", "deg", -25, 25},
                   {"head_roll", "deg", -20, 20},
                   {"gaze_x", "deg", -30, 30},
                   {"gaze_y", "deg", -20, 20}},
      .speech_controls = {"jaw",
                          "jaw_thrust",
                          "lip_width",
                          "lip_protrusion",
                          "lip_funnel",
                          "upper_lip_raise",
                          "lower_lip_raise",
                          "lower_lip_tuck",
                          "corner_x",
                          "corner_y",
                          "corner_z",
                          "lip_closure",
                          "lip_compression",
                          "cheek_puff",
                          "tongue_length",
                          "tongue_angle",
                          "tongue_width",
                          "tongue_thickness",
                          "tongue_tip",
                          "tongue_back"}};
}

}  // namespace bimodal::protocols
