#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "synth/speech/expression.hpp"

namespace bimodal::runner {

/// Adds --expression.
void add_expression_option(CLI::App& verb, std::vector<std::string>& expressions);

/// Reads "smile=0.7", "surprise" (at full strength), ... Throws Error, naming what there is, for an
/// unknown expression, one that is shown twice, or a strength that is not from 0 to 1.
[[nodiscard]] std::vector<synth::ShownExpression> read_expressions(
    const std::vector<std::string>& texts);

}  // namespace bimodal::runner
