#include "analysis/report/print/figure_pdf.hpp"

#include "analysis/report/print/drawing.hpp"
#include "analysis/report/print/pdf_file.hpp"

namespace bimodal::analysis {

std::string figure_pdf(std::string_view svg, const std::string& made_utc) {
  const SvgDrawing drawing{svg};
  PdfFile file{drawing.width(), drawing.height()};
  file.set_date(made_utc);
  drawing.paint(file.context(), {0.0, 0.0, drawing.width(), drawing.height()});
  return file.finish();
}

}  // namespace bimodal::analysis
