#pragma once

#include <cmath>
#include <filesystem>
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

/// A script's variable may be empty where a name is meant.
[[nodiscard]] inline CLI::Validator name_that_is_not_empty() {
  return {[](std::string& text) -> std::string {
            return text.empty() ? "an empty name was given; leave the option out or name one" : "";
          },
          ""};
}

/// CLI::Range lets "nan" pass, since it is neither below nor above anything.
[[nodiscard]] inline CLI::Validator finite_number() {
  return {[](std::string& text) -> std::string {
            double number = 0;
            const bool is_number = CLI::detail::lexical_cast(text, number);
            if (is_number && std::isfinite(number)) return {};
            return "'" + text + "' is not a number";
          },
          ""};
}

/// For a file that is to be written: told before long work, not after it.
[[nodiscard]] inline CLI::Validator in_a_folder_that_exists() {
  return {[](std::string& text) -> std::string {
            const auto folder = std::filesystem::absolute(text).parent_path();
            if (std::filesystem::is_directory(folder)) return {};
            return "there is no folder " + folder.string() + "; make it first";
          },
          ""};
}

}  // namespace bimodal::runner
