#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/cli/verb.hpp"
#include "analysis/report/provenance.hpp"
#include "analysis/scoring/classes.hpp"
#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// Which confusion matrix a verb is about: that of a file, or of a unit and a condition of
/// stored sessions.
struct MatrixChoice {
  AnalysisRequest analysis;
  std::string unit;
  std::string condition;
  /// What of labels is put together: a preset, "clusters" of the matrix itself, or a CSV; empty:
  /// nothing.
  std::string classes;
};

/// Adds DATA, the options that choose trials, --unit, --condition and --classes. `choice` must
/// outlive `verb`.
void add_matrix_options(CLI::App& verb, MatrixChoice& choice);

/// A matrix, and what must be known of it.
struct ChosenMatrix {
  std::string title;           ///< what the file says it is, or "m.csv"; "Vowels, condition visual"
  ConfusionMatrix matrix;      ///< of classes, where these were wanted
  ConfusionMatrix uncombined;  ///< of the labels themselves
  std::optional<ClassMap> classes;
  std::string left_out;          ///< of trials: what is not in the matrix, as a line of text
  std::size_t participants = 0;  ///< whose responses are in it; 0: not known
  Provenance provenance;
  std::vector<std::string> warnings;
};

/// Whether a file is a confusion matrix (by its name's ending; as CSV, by its first line too).
[[nodiscard]] bool is_matrix_file(const std::filesystem::path& file,
                                  const AnalysisRequest& request);

/// Whether DATA is a matrix. Throws Error where options would choose among its trials, which it
/// does not have, or where there are more files.
[[nodiscard]] bool chooses_matrix_file(const MatrixChoice& choice);

/// Of trials; `chosen` gets everything but title and matrix. Absent, and said why on `console.err`,
/// if no trial is left. Throws Error or StoreError.
[[nodiscard]] std::optional<UnitConfusions> tabulate_chosen(const MatrixChoice& choice,
                                                            Console console,
                                                            ChosenMatrix& chosen);

/// Absent, and said why on `console.err`, if no response is left. Throws Error or StoreError.
[[nodiscard]] std::optional<ChosenMatrix> load_chosen(const MatrixChoice& choice, Console console);

}  // namespace bimodal::analysis
