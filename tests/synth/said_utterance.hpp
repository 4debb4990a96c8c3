#pragma once

#include <chrono>
#include <vector>

#include "stimuli/timeline/utterance.hpp"

namespace bimodal::synth {

struct Said {
  Phone phone;
  std::chrono::milliseconds duration;
};

/// Phones one after the other, from time zero.
inline Utterance utterance_of(const std::vector<Said>& sequence) {
  Utterance utterance;
  for (const auto& [phone, duration] : sequence) {
    utterance.phones.push_back({.phone = phone, .start = utterance.end(), .duration = duration});
  }
  return utterance;
}

}  // namespace bimodal::synth
