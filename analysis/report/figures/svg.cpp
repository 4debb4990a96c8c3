#include "analysis/report/figures/svg.hpp"

#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "stimuli/base/markup.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kPointsPerMillimetre = 72.0 / 25.4;

/// Advance widths of DejaVu Sans in parts of the size, by kinds of letters.
double width_of_letter(unsigned char letter) {
  constexpr std::string_view kNarrow = "iIjl.,:;'|!ft()[] -/";
  constexpr std::string_view kWide = "mwMW%@";
  if (kNarrow.find(static_cast<char>(letter)) != std::string_view::npos) return 0.39;
  if (kWide.find(static_cast<char>(letter)) != std::string_view::npos) return 0.98;
  if (letter >= 'A' && letter <= 'Z') return 0.72;
  if (letter >= 0x80) return 0.84;  // one character beyond ASCII; a minus sign is that wide
  return 0.635;
}

std::string_view name(Anchor anchor) {
  switch (anchor) {
    case Anchor::Middle:
      return "middle";
    case Anchor::End:
      return "end";
    case Anchor::Start:
      break;
  }
  return "start";
}

std::string place_of_text(double x, double y, bool is_upright) {
  if (!is_upright) return fmt::format("x='{}' y='{}'", coordinate(x), coordinate(y));
  return fmt::format("transform='translate({} {}) rotate(-90)'", coordinate(x), coordinate(y));
}

}  // namespace

double millimetres(PaperWidth width) {
  return width == PaperWidth::OneColumn ? 85.0 : 174.0;
}

double points(PaperWidth width) {
  return millimetres(width) * kPointsPerMillimetre;
}

double width_of(std::string_view text, double size, bool is_bold) {
  double sum = 0.0;
  for (const char byte : text) {
    const auto letter = static_cast<unsigned char>(byte);
    const bool continues = (letter & 0xC0U) == 0x80U;  // a further byte of a UTF-8 character
    if (!continues) sum += width_of_letter(letter);
  }
  return sum * size * (is_bold ? 1.1 : 1.0);
}

std::string coordinate(double value) {
  const double rounded = std::round(value * 100.0) / 100.0;
  return fmt::format("{:.8g}", rounded == 0.0 ? 0.0 : rounded);  // no minus before 0
}

std::string standing_alone(std::string element) {
  constexpr std::string_view kOpening = "<svg ";
  element.insert(kOpening.size(), "xmlns='http://www.w3.org/2000/svg' ");
  element.insert(element.find('>') + 1, "\n<rect width='100%' height='100%' fill='#fff'/>");
  return element;
}

Svg::Svg(double width, std::string title, std::string description)
    : width_{width}, title_{std::move(title)}, description_{std::move(description)} {}

void Svg::text(double x, double y, std::string_view words, const Lettering& lettering) {
  if (words.empty()) return;
  fmt::format_to(std::back_inserter(content_),
                 "<text {} font-size='{}' fill='{}'",
                 place_of_text(x, y, lettering.is_upright),
                 coordinate(lettering.size),
                 lettering.colour);
  if (lettering.anchor != Anchor::Start) {
    fmt::format_to(std::back_inserter(content_), " text-anchor='{}'", name(lettering.anchor));
  }
  if (lettering.is_bold) content_ += " font-weight='bold'";
  if (lettering.is_italic) content_ += " font-style='italic'";
  fmt::format_to(std::back_inserter(content_), ">{}</text>\n", escaped(words));
}

void Svg::box(const Box& box, const Paint& paint) {
  shape(fmt::format("rect x='{}' y='{}' width='{}' height='{}'",
                    coordinate(box.left),
                    coordinate(box.top),
                    coordinate(box.width),
                    coordinate(box.height)),
        paint);
}

void Svg::line(double x1, double y1, double x2, double y2, const Paint& paint) {
  shape(fmt::format("line x1='{}' y1='{}' x2='{}' y2='{}'",
                    coordinate(x1),
                    coordinate(y1),
                    coordinate(x2),
                    coordinate(y2)),
        paint);
}

void Svg::circle(double x, double y, double radius, const Paint& paint) {
  shape(fmt::format(
            "circle cx='{}' cy='{}' r='{}'", coordinate(x), coordinate(y), coordinate(radius)),
        paint);
}

void Svg::path(std::string_view commands, const Paint& paint) {
  shape(fmt::format("path d='{}'", commands), paint);
}

void Svg::shape(std::string_view geometry, const Paint& paint) {
  const auto element = geometry.substr(0, geometry.find(' '));
  fmt::format_to(std::back_inserter(content_), "<{} fill='{}'", geometry, paint.fill);
  if (paint.stroke != "none") {
    fmt::format_to(std::back_inserter(content_),
                   " stroke='{}' stroke-width='{}'",
                   paint.stroke,
                   coordinate(paint.width));
  }
  if (!paint.dashes.empty()) {
    fmt::format_to(std::back_inserter(content_), " stroke-dasharray='{}'", paint.dashes);
  }
  if (paint.opacity < 1.0) {
    fmt::format_to(std::back_inserter(content_), " opacity='{}'", coordinate(paint.opacity));
  }
  if (!paint.cell.empty()) {
    fmt::format_to(std::back_inserter(content_), " data-cell='{}'", escaped(paint.cell));
  }
  if (!paint.side.empty()) {
    fmt::format_to(std::back_inserter(content_), " data-side='{}'", paint.side);
  }
  if (paint.meaning.empty()) {
    content_ += "/>\n";
  } else {
    fmt::format_to(
        std::back_inserter(content_), "><title>{}</title></{}>\n", escaped(paint.meaning), element);
  }
}

std::string Svg::finish(double height) {
  return fmt::format(
      "<svg viewBox='0 0 {0} {1}' width='{2}mm' height='{3}mm' role='img' "
      "font-family='Arial, Helvetica, sans-serif' stroke-linejoin='round' aria-label='{4}{5}{6}'>\n"
      "<title>{4}</title>\n{7}</svg>\n",
      coordinate(width_),
      coordinate(height),
      coordinate(width_ / kPointsPerMillimetre),
      coordinate(height / kPointsPerMillimetre),
      escaped(title_),
      description_.empty() ? "" : ". ",
      escaped(description_),
      content_);
}

}  // namespace bimodal::analysis
