#pragma once

#include <CLI/CLI.hpp>

#include "analysis/scoring/scoring_rules.hpp"

namespace bimodal::analysis {

/// Adds --tolerate, --no-homophones, --out-of-dictionary, --costs and --ties. `rules` must outlive
/// `verb`.
void add_scoring_options(CLI::App& verb, ScoringRules& rules);

}  // namespace bimodal::analysis
