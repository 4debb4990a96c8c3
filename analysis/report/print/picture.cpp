#include "analysis/report/print/picture.hpp"

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <gdk-pixbuf/gdk-pixbuf.h>

#include "stimuli/base/error.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kWidest = 460.0;  ///< on the page, in pixels of 1/96 inch

struct Release {
  void operator()(GdkPixbufLoader* loader) const { g_object_unref(loader); }

  void operator()(guchar* bytes) const { g_free(bytes); }
};

}  // namespace

std::string drawing_of_picture(std::string_view source) {
  const auto comma = source.find(',');
  const std::string coded{comma == std::string_view::npos ? "" : source.substr(comma + 1)};
  gsize length = 0;
  const std::unique_ptr<guchar, Release> bytes{g_base64_decode(coded.c_str(), &length)};
  const std::unique_ptr<GdkPixbufLoader, Release> loader{gdk_pixbuf_loader_new()};
  const bool whole = gdk_pixbuf_loader_write(loader.get(), bytes.get(), length, nullptr) == TRUE;
  const bool closed = gdk_pixbuf_loader_close(loader.get(), nullptr) == TRUE;
  const auto* const picture = gdk_pixbuf_loader_get_pixbuf(loader.get());
  if (!whole || !closed || picture == nullptr) {
    throw Error{
        "making the PDF of the report: an attached picture cannot be read; is its file whole?"};
  }
  const int width = gdk_pixbuf_get_width(picture);
  const int height = gdk_pixbuf_get_height(picture);
  const double scale = std::min(1.0, kWidest / width);
  return fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' width='{2:g}' height='{3:g}'>"
      "<image width='{0}' height='{1}' href='{4}'/></svg>",
      width,
      height,
      width * scale,
      height * scale,
      source);
}

}  // namespace bimodal::analysis
