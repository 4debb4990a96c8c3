#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "analysis/cli/program.hpp"
#include "analysis/data/gathering.hpp"
#include "analysis/report/results.hpp"

namespace bimodal::analysis {

/// What every verb needs to come to results.
struct AnalysisRequest {
  std::vector<std::filesystem::path> data;
  std::filesystem::path mapping;  ///< of tables of trials; empty: none
  Selection selection;
  std::vector<Criterion> criteria;
  std::filesystem::path lexicon;     ///< as CSV; empty: a dictionary is asked
  std::filesystem::path dictionary;  ///< empty: the installed one
  ScoringRules rules;
  CrossedBootstrap::Options bootstrap;
  std::optional<FaceConditions> faces;  ///< absent: no two faces are compared
  Resampling comparison;
};

/// What the user asked for, filled by the command line; run after it has been read.
using Verb = std::function<ExitCode(Console)>;

/// Adds DATA and the options that choose trials, the dictionary and the rules of scoring. `request`
/// must outlive `verb`.
void add_analysis_options(CLI::App& verb, AnalysisRequest& request);

/// Whether a file is a table of trials as CSV (and not a matrix of counts). Throws Error if it
/// cannot be read.
[[nodiscard]] bool is_trial_file(const std::filesystem::path& file, const AnalysisRequest& request);

/// The lexicon, else the dictionary, else the installed one. Throws Error.
[[nodiscard]] Dictionary dictionary_of(const AnalysisRequest& request);

/// Adds --seed and --resamples to a verb that draws nothing at random, so that scripts may give
/// them to every verb.
void add_idle_resampling(CLI::App& verb);

/// Adds --seed, of what is drawn at random. `seed` must outlive `verb`.
void add_seed_option(CLI::App& verb, Seed& seed);

/// Reads, scores and counts. Throws Error or StoreError.
[[nodiscard]] Results analyse_request(const AnalysisRequest& request, Console console);

/// "no trial left to analyse: 12 stored, 12 excluded (12 practice trial)": why there is nothing.
[[nodiscard]] std::string nothing_left(const Dataset& dataset);

/// Each adds its verb to the program; `chosen` becomes the verb that the user named.
void add_score_verb(CLI::App& program, Verb& chosen);
void add_report_verb(CLI::App& program,
                     Verb& chosen,
                     std::span<const std::string> arguments);  ///< the command line, to be told
void add_matrix_verb(CLI::App& program, Verb& chosen);
void add_information_verb(CLI::App& program, Verb& chosen);
void add_sinfa_verb(CLI::App& program, Verb& chosen);
void add_cluster_verb(CLI::App& program, Verb& chosen);
void add_mds_verb(CLI::App& program, Verb& chosen);
void add_proportions_verb(CLI::App& program, Verb& chosen);
void add_compare_verb(CLI::App& program, Verb& chosen);
void add_export_verb(CLI::App& program, Verb& chosen);

/// Of the program, e.g. "0.1.0".
[[nodiscard]] std::string_view program_version();

/// With its version: "bimodal-analysis 0.1.0".
[[nodiscard]] std::string program_name();

}  // namespace bimodal::analysis
