#include "stimuli/figures/figure.hpp"

#include <array>
#include <cctype>

#include <fmt/format.h>

#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/markup.hpp"
#include "stimuli/figures/canvas.hpp"
#include "stimuli/figures/layout.hpp"

namespace bimodal {

namespace {

constexpr std::array<FigureColour, 8> kColours{
    0x000000, 0xD55E00, 0x0072B2, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9, 0x806000};
constexpr double kLargestSide = 14'000;  ///< points; PDF and PNG readers refuse larger ones

/// Cairo numbers its pages through the life of the program; nothing refers to the number.
void remove_page_number(std::string& svg) {
  constexpr std::string_view kAttribute = " id=\"surface";
  const auto at = svg.find(kAttribute);
  if (at == std::string::npos) return;
  svg.erase(at, svg.find('"', at + kAttribute.size()) + 1 - at);
}

/// The size of the whole figure; throws if it cannot be drawn.
FigureSize judged_size(const Figure& figure) {
  if (figure.panels.empty()) throw Error{"a figure without panels cannot be drawn"};
  const auto size = size_of(figure);
  if (size.width > kLargestSide || size.height > kLargestSide) {
    throw Error{fmt::format("a figure of {:.0f} x {:.0f} points is too large; draw fewer panels",
                            size.width,
                            size.height)};
  }
  return size;
}

}  // namespace

FigureColour figure_colour(std::size_t index) {
  return kColours.at(index % kColours.size());
}

std::string svg_of(const Figure& figure) {
  const auto size = judged_size(figure);
  Canvas canvas{Canvas::Kind::Svg, size};
  draw(figure, size, canvas);
  auto text = canvas.finish();
  remove_page_number(text);
  const auto root = text.find("<svg");
  const auto after = text.find('>', root) + 1;
  text.insert(
      after,
      fmt::format(
          "\n<title>{}</title>\n<desc>{}</desc>", escaped(figure.title), escaped(figure.caption)));
  return text;
}

void write_figure(const Figure& figure, const std::filesystem::path& file) {
  const auto ending = file.extension().string();
  if (ending == ".svg") {
    write_file(file, svg_of(figure));
    return;
  }
  if (ending != ".pdf" && ending != ".png") {
    throw Error{fmt::format(
        "{}: figures are written as .svg, .pdf or .png; give one of these endings", file.string())};
  }
  const auto size = judged_size(figure);
  Canvas canvas{ending == ".pdf" ? Canvas::Kind::Pdf : Canvas::Kind::Png, size};
  draw(figure, size, canvas);
  write_file(file, canvas.finish());
}

}  // namespace bimodal
