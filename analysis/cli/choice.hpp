#pragma once

#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "stimuli/base/lower_case.hpp"

namespace bimodal::analysis {

/// Adds an option whose values are names in lower case, which may be typed in any. `value` must
/// outlive `verb`.
template <typename Value>
CLI::Option* add_choice(CLI::App& verb,
                        const std::string& option,
                        Value& value,
                        const std::vector<std::pair<std::string, Value>>& choices,
                        const std::string& meaning) {
  std::vector<std::string> names;
  for (const auto& choice : choices) names.push_back(choice.first);
  return verb
      .add_option_function<std::string>(
          option,
          [&value, choices](const std::string& name) {
            for (const auto& choice : choices) {
              if (choice.first == lower_case(name)) value = choice.second;
            }
          },
          meaning)
      ->check(CLI::IsMember(names, CLI::ignore_case));
}

}  // namespace bimodal::analysis
