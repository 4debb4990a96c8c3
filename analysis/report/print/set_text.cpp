#include "analysis/report/print/set_text.hpp"

#include <charconv>
#include <cstdint>

#include <fmt/format.h>
#include <pango/pangocairo.h>

namespace bimodal::analysis {

namespace {

constexpr double kUnits = PANGO_SCALE;  // of Pango in a point

PangoRectangle extents_of(PangoLayoutLine* line) {
  PangoRectangle logical{};
  pango_layout_line_get_extents(line, nullptr, &logical);
  return logical;
}

}  // namespace

void SetText::Release::operator()(PangoLayout* layout) const {
  g_object_unref(layout);
}

SetText::SetText(cairo_t* context, const std::string& markup, const TextLook& look, double width)
    : context_{context}, layout_{pango_cairo_create_layout(context)}, colour_{look.colour} {
  // A point of the page is a unit of Cairo, and lines are the same wherever they are laid out.
  pango_cairo_context_set_resolution(pango_layout_get_context(layout_.get()), 72.0);
  pango_context_set_round_glyph_positions(pango_layout_get_context(layout_.get()), FALSE);
  auto* const options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  pango_cairo_context_set_font_options(pango_layout_get_context(layout_.get()), options);
  cairo_font_options_destroy(options);
  auto* const font = pango_font_description_from_string("Arial, Helvetica, sans-serif");
  pango_font_description_set_absolute_size(font, look.size * kUnits);
  if (look.is_bold) pango_font_description_set_weight(font, PANGO_WEIGHT_BOLD);
  pango_layout_set_font_description(layout_.get(), font);
  pango_font_description_free(font);
  pango_layout_set_wrap(layout_.get(), PANGO_WRAP_WORD_CHAR);
  pango_layout_set_width(layout_.get(), width < 0.0 ? -1 : static_cast<int>(width * kUnits));
  pango_layout_set_alignment(layout_.get(), look.is_right ? PANGO_ALIGN_RIGHT : PANGO_ALIGN_LEFT);
  pango_layout_set_line_spacing(layout_.get(), 1.25F);
  // A hash that is parted is to keep its characters, and no others.
  const auto whole = fmt::format("<span insert_hyphens='false'>{}</span>", markup);
  pango_layout_set_markup(layout_.get(), whole.c_str(), static_cast<int>(whole.size()));
}

double SetText::width() const {
  PangoRectangle logical{};
  pango_layout_get_extents(layout_.get(), nullptr, &logical);
  return logical.width / kUnits;
}

double SetText::widest_word() const {
  const std::unique_ptr<PangoLayout, Release> apart{pango_layout_copy(layout_.get())};
  pango_layout_set_wrap(apart.get(), PANGO_WRAP_WORD);
  pango_layout_set_width(apart.get(), 0);
  PangoRectangle logical{};
  pango_layout_get_extents(apart.get(), nullptr, &logical);
  return logical.width / kUnits;
}

double SetText::height() const {
  double sum = 0.0;
  for (int line = 0; line < lines(); ++line) sum += line_height(line);
  return sum;
}

int SetText::lines() const {
  return pango_layout_get_line_count(layout_.get());
}

double SetText::line_height(int line) const {
  return extents_of(pango_layout_get_line_readonly(layout_.get(), line)).height / kUnits;
}

void SetText::paint(double x, double y) const {
  for (int line = 0; line < lines(); ++line) {
    paint_line(line, x, y);
    y += line_height(line);
  }
}

void SetText::paint_line(int line, double x, double y) const {
  auto* const set = pango_layout_get_line_readonly(layout_.get(), line);
  const auto logical = extents_of(set);
  const double width = pango_layout_get_width(layout_.get()) / kUnits;
  const bool is_right = pango_layout_get_alignment(layout_.get()) == PANGO_ALIGN_RIGHT;
  const double indent = is_right && width > 0.0 ? width - logical.width / kUnits : 0.0;
  set_colour(context_, colour_);
  cairo_move_to(context_, x + indent, y - logical.y / kUnits);
  pango_cairo_show_layout_line(context_, set);
}

void set_colour(cairo_t* context, std::string_view colour) {
  std::uint32_t value = 0;
  std::from_chars(colour.data() + 1, colour.data() + colour.size(), value, 16);
  cairo_set_source_rgb(context,
                       static_cast<double>(value >> 16U & 255U) / 255.0,
                       static_cast<double>(value >> 8U & 255U) / 255.0,
                       static_cast<double>(value & 255U) / 255.0);
}

}  // namespace bimodal::analysis
