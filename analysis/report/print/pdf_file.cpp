#include "analysis/report/print/pdf_file.hpp"

#include <utility>

#include <cairo-pdf.h>
#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::analysis {

namespace {

cairo_status_t append(void* content, const unsigned char* bytes, unsigned int length) {
  for (unsigned int i = 0; i < length; ++i) {
    static_cast<std::string*>(content)->push_back(static_cast<char>(bytes[i]));
  }
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

PdfFile::PdfFile(double width, double height)
    : content_{std::make_unique<std::string>()},
      surface_{cairo_pdf_surface_create_for_stream(&append, content_.get(), width, height)},
      context_{cairo_create(surface_.get())} {
  set_date({});
}

void PdfFile::set_title(const std::string& title) {
  cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
}

void PdfFile::set_date(const std::string& made_utc) {
  const auto date = made_utc.empty() ? std::string{"1970-01-01T00:00:00Z"} : made_utc;
  cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_CREATE_DATE, date.c_str());
}

int PdfFile::add_to_outline(const std::string& words, int parent) {
  return cairo_pdf_surface_add_outline(surface_.get(),
                                       parent,
                                       words.c_str(),
                                       fmt::format("page={}", page_).c_str(),
                                       CAIRO_PDF_OUTLINE_FLAG_OPEN);
}

void PdfFile::next_page() {
  cairo_show_page(context_.get());
  ++page_;
}

std::string PdfFile::finish() {
  const auto drawn = cairo_status(context_.get());
  context_.reset();
  cairo_surface_finish(surface_.get());
  const auto written = cairo_surface_status(surface_.get());
  for (const auto status : {drawn, written}) {
    if (status == CAIRO_STATUS_SUCCESS) continue;
    throw Error{fmt::format("drawing a PDF: {}; use the SVG or HTML file instead",
                            cairo_status_to_string(status))};
  }
  return std::move(*content_);
}

}  // namespace bimodal::analysis
