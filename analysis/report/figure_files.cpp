#include "analysis/report/figure_files.hpp"

#include <utility>

#include <fmt/format.h>

#include "analysis/report/print/figure_pdf.hpp"
#include "analysis/report/report_figures.hpp"

namespace bimodal::analysis {

std::vector<ReportFile> figure_files(const Results& results, const Making& making) {
  std::vector<ReportFile> files;
  for (const auto& figure : report_figures(results)) {
    for (const auto width : {PaperWidth::OneColumn, PaperWidth::TwoColumns}) {
      const auto name = fmt::format("figures/{}-{:g}mm", figure.name, millimetres(width));
      auto svg = standing_alone(figure.draw(width));
      auto pdf = figure_pdf(svg, making.made_utc);
      files.push_back({.name = name + ".svg", .content = std::move(svg)});
      files.push_back({.name = name + ".pdf", .content = std::move(pdf)});
    }
  }
  return files;
}

}  // namespace bimodal::analysis
