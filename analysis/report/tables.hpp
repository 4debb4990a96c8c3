#pragma once

#include <string>
#include <vector>

#include "analysis/report/page.hpp"
#include "analysis/report/results.hpp"

namespace bimodal::analysis {

/// A file of the report, beside the page.
struct ReportFile {
  std::string name;
  std::string content;
};

/// Tidy CSV tables (trials, words, proportions, benefits, confusions, likeness, exclusions; where
/// two faces are compared also comparison and contrasts), columns.csv that says what each of their
/// columns means, and manifest.json: version, options, hashes of the input.
[[nodiscard]] std::vector<ReportFile> report_tables(const Results& results, const Making& making);

}  // namespace bimodal::analysis
