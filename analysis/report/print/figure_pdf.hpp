#pragma once

#include <string>
#include <string_view>

namespace bimodal::analysis {

/// An SVG document as a PDF of one page of its size, with text as text and fonts embedded.
/// `made_utc` (ISO 8601) becomes its date: the same document and date give the same bytes. Throws
/// Error if it cannot be drawn.
[[nodiscard]] std::string figure_pdf(std::string_view svg, const std::string& made_utc);

}  // namespace bimodal::analysis
