#pragma once

// Tracks that the model itself made, of parameters that are known.

#include <cmath>
#include <string>
#include <vector>

#include "stimuli/base/random.hpp"
#include "synth/fitting/fit_problem.hpp"

namespace bimodal::synth {

/// Random numbers for every part; alpha and t_o are those of its class, theta of all.
inline std::vector<PartDynamics> random_dynamics(Random& random, double lowest, double highest) {
  std::vector<PartDynamics> all(parts().size());
  std::vector<PartDynamics> classes(part_classes().size());
  for (auto& one : classes) {
    one.log_alpha = 2 * random.uniform() - 1;
    one.offset_ms = 40 * random.uniform() - 20;
  }
  const double log_theta = std::log(0.010 + 0.020 * random.uniform());
  for (std::size_t part = 0; part < all.size(); ++part) {
    all[part] = classes[class_of(part)];
    all[part].target = lowest + (highest - lowest) * random.uniform();
    all[part].log_theta_before = log_theta;
    all[part].log_theta_after = log_theta;
  }
  return all;
}

/// Sentences of `phones` in random order, each of them in every one, measured 100 times a second.
inline std::vector<MeasuredClip> generated_clips(Random& random,
                                                 const std::vector<Phone>& phones,
                                                 const std::vector<PartDynamics>& dynamics,
                                                 const std::vector<double>& talkers,
                                                 MeasureKind kind) {
  std::vector<MeasuredClip> clips;
  for (const double talker : talkers) {
    auto order = phones;
    shuffle<Phone>(order, random);
    Utterance said{{{.phone = Phone::Rest, .duration = std::chrono::milliseconds{400}}}};
    for (const Phone phone : order) {
      const std::chrono::milliseconds duration{60 + random.below(120)};
      said.phones.push_back({.phone = phone, .start = said.end(), .duration = duration});
    }
    auto& clip = clips.emplace_back();
    clip.name = "clip" + std::to_string(clips.size());
    clip.spoken = spoken_parts(said);
    clip.speech_start_ms = 400;
    clip.speech_end_ms = Milliseconds{said.end()}.count();
    std::vector<PartDynamics> asked;
    for (const auto& one : clip.spoken) asked.push_back(dynamics[one.part]);
    for (double time = 300; time <= clip.speech_end_ms + 100; time += 10) {
      clip.time_ms.push_back(time);
      clip.values.push_back(shown(kind, blended(clip.spoken, asked, time), talker));
    }
  }
  return clips;
}

}  // namespace bimodal::synth
