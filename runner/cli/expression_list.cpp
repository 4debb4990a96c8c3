#include "runner/cli/expression_list.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

double read_strength(std::string_view setting, std::string_view text) {
  double strength = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), strength);
  const bool is_number = fault == std::errc{} && end == text.data() + text.size();
  if (is_number && strength >= 0 && strength <= 1) return strength;
  throw Error{
      fmt::format("--expression: '{}' has no strength from 0 to 1; write e.g. smile=0.7", setting)};
}

const synth::Expression& expression_called(std::string_view name) {
  if (const auto* const found = synth::expression_from_name(name)) return *found;
  std::vector<std::string_view> names;
  for (const auto& expression : synth::expressions()) names.push_back(expression.name);
  throw Error{fmt::format(
      "--expression: the face knows no '{}'; there are {}", name, fmt::join(names, ", "))};
}

}  // namespace

void add_expression_option(CLI::App& verb, std::vector<std::string>& expressions) {
  verb.add_option("--expression",
                  expressions,
                  "on top of what the face does, e.g. smile=0.7,surprise; see bimodal face --list")
      ->delimiter(',')
      ->allow_extra_args(false);
}

std::vector<synth::ShownExpression> read_expressions(const std::vector<std::string>& texts) {
  std::vector<synth::ShownExpression> shown;
  for (const std::string_view text : texts) {
    const auto equals = text.find('=');
    const auto& expression = expression_called(text.substr(0, equals));
    const double strength =
        equals == std::string_view::npos ? 1.0 : read_strength(text, text.substr(equals + 1));
    if (std::ranges::find(shown, &expression, &synth::ShownExpression::expression) != shown.end()) {
      throw Error{
          fmt::format("--expression: {} is shown twice; keep one of them", expression.name)};
    }
    shown.push_back({&expression, strength});
  }
  return shown;
}

}  // namespace bimodal::runner
