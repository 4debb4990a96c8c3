#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "stimuli/base/random.hpp"
#include "stimuli/base/whole_number.hpp"

namespace bimodal::runner {

/// Checks for CLI::Option::check(), with messages that say what is wanted.
[[nodiscard]] inline CLI::Validator whole_number_from(int lowest) {
  return {[lowest](std::string& text) { return whole_number_fault(text, lowest); }, ""};
}

[[nodiscard]] inline CLI::Validator seed_number() {
  return {[](std::string& text) { return whole_number_fault(text, Seed{0}); }, ""};
}

}  // namespace bimodal::runner
