#include "runner/devices/simulated/simulated_input.hpp"

#include <utility>

#include <fmt/format.h>

namespace bimodal::runner {

SimulatedInput::SimulatedInput(const Clock& clock, Options options)
    : clock_{clock}, options_{std::move(options)} {}

void SimulatedInput::start() {
  ++captures_;
  running_ = true;
  start_ = clock_.now();
  delivered_ = 0;
}

void SimulatedInput::collect(std::vector<float>& samples) {
  if (!running_) return;
  const auto due = nearest_sample(clock_.now() - start_, options_.rate).count();
  for (; delivered_ < static_cast<std::size_t>(due); ++delivered_) {
    samples.push_back(sample_at(delivered_));
  }
}

void SimulatedInput::stop() {
  running_ = false;
}

float SimulatedInput::sample_at(std::size_t index) const {
  if (captures_ > 1 && !options_.utterances.empty()) {
    const auto& utterance = options_.utterances[(captures_ - 2) % options_.utterances.size()];
    const auto begin =
        static_cast<std::size_t>(nearest_sample(options_.reaction, options_.rate).count());
    if (index >= begin && index - begin < utterance.size()) return utterance[index - begin];
  }
  return options_.room.empty() ? 0.0F : options_.room[index % options_.room.size()];
}

std::string SimulatedInput::description() const {
  return fmt::format("simulated: {} utterances of a recording, {} samples per second",
                     options_.utterances.size(),
                     options_.rate.count());
}

}  // namespace bimodal::runner
