#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/report/attachment.hpp"
#include "analysis/report/results.hpp"

namespace bimodal::analysis {

/// What the page says about its own making.
struct Making {
  std::string program;    ///< "bimodal-analysis 0.1.0"
  std::string made_utc;   ///< ISO 8601
  std::string selection;  ///< options that chose the trials, in words
  std::string command;    ///< as typed into a shell; empty: not made from a command line
};

/// The report as one HTML file (well-formed as XML too) that needs no other file and no network,
/// and can be printed. Nothing in it needs its script, which lists the trials of a cell that is
/// clicked.
[[nodiscard]] std::string report_page(const Results& results,
                                      std::span<const Attachment> attachments,
                                      const Making& making);

}  // namespace bimodal::analysis
