#include "runner/preparation/face_terms.hpp"

#include "runner/preparation/point_names.hpp"
#include "runner/preparation/view_names.hpp"
#include "stimuli/base/asset.hpp"
#include "synth/render/head_part.hpp"
#include "synth/speech/control.hpp"
#include "synth/speech/expression.hpp"

namespace bimodal::runner {

namespace {

bool is_of_speech(synth::Control control) {
  return static_cast<std::size_t>(control) < synth::kSpeechControlCount;
}

std::vector<protocols::FacePart> parts() {
  std::vector<protocols::FacePart> parts;
  for (const auto name : synth::part_names()) {
    parts.push_back({name, static_cast<std::uint32_t>(synth::parts_named(name)->to_ulong())});
  }
  return parts;
}

std::vector<protocols::FaceExpression> expressions() {
  std::vector<protocols::FaceExpression> expressions;
  for (const auto& expression : synth::expressions()) {
    auto& term = expressions.emplace_back(protocols::FaceExpression{expression.name, {}});
    for (const auto& [control, amount] : expression.shares) {
      if (!is_of_speech(control)) term.adds[synth::describe(control).name] = amount;
    }
  }
  return expressions;
}

}  // namespace

protocols::FaceTerms face_terms() {
  protocols::FaceTerms terms;
  terms.views = view_names();
  for (const auto& [name, points] : kPointNames) terms.points.push_back(name);
  terms.materials = asset_names("synth/assets/materials", ".json");
  terms.parts = parts();
  terms.expressions = expressions();
  for (const auto& row : synth::controls()) {
    if (is_of_speech(row.control)) {
      terms.speech_controls.push_back(row.name);
    } else {
      terms.controls.push_back({row.name, row.unit, row.lowest, row.highest});
    }
  }
  return terms;
}

}  // namespace bimodal::runner
