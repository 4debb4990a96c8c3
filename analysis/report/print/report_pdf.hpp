#pragma once

#include <string>

namespace bimodal::analysis {

/// The report's page as a PDF on A4 paper, with page numbers and an outline; made from the page
/// itself, so that both say the same. Closed <details> are left out. Its first
/// heading becomes its title and `made_utc` (ISO 8601) its date: the same page and date give the
/// same bytes. Throws Error if the page is not well-formed.
[[nodiscard]] std::string report_pdf(const std::string& page, const std::string& made_utc);

}  // namespace bimodal::analysis
