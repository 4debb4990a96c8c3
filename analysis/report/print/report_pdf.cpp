#include "analysis/report/print/report_pdf.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "analysis/report/print/blocks.hpp"
#include "analysis/report/print/drawing.hpp"
#include "analysis/report/print/pdf_file.hpp"
#include "analysis/report/print/set_table.hpp"
#include "analysis/report/print/set_text.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kPoints = 72.0 / 25.4;  ///< in a millimetre
constexpr double kPageWidth = 210.0 * kPoints;
constexpr double kPageHeight = 297.0 * kPoints;
constexpr double kLeft = 18.0 * kPoints;
constexpr double kTop = 18.0 * kPoints;
constexpr double kWidth = 174.0 * kPoints;  ///< a journal's two columns
constexpr double kBottom = kPageHeight - 20.0 * kPoints;
constexpr double kBody = 9.0;
constexpr double kCaption = 8.0;
constexpr double kIndent = 12.0;          ///< of list items and warnings
constexpr double kBetweenFigures = 10.0;  ///< side by side
constexpr double kTogether = 40.0;        ///< a heading has at least that much below it
constexpr std::string_view kWarningTint = "#fdf3dc";
constexpr std::string_view kWarningEdge = "#b35806";

/// Letters and space of headings, by level.
struct HeadingLook {
  double size;
  double above;
  double below;
};

constexpr std::array<HeadingLook, 3> kHeadings{
    {{17.0, 0.0, 4.0}, {13.0, 16.0, 5.0}, {10.0, 9.0, 3.0}}};

/// Drawings side by side where they have room, and so small that they fit on a page.
struct Gallery {
  struct Piece {
    SvgDrawing drawing;
    Box place;  ///< within the gallery
  };

  std::vector<Piece> pieces;
  double height = 0.0;
};

Gallery arrange_drawings(const std::vector<std::string>& drawings, double tallest) {
  Gallery gallery;
  double left = 0.0;
  double top = 0.0;
  for (const auto& svg : drawings) {
    SvgDrawing drawing{svg};
    const double scale = std::min({1.0, kWidth / drawing.width(), tallest / drawing.height()});
    const double width = drawing.width() * scale;
    const double height = drawing.height() * scale;
    if (left > 0.0 && left + width > kWidth + 0.5) {
      left = 0.0;
      top = gallery.height + kBetweenFigures;
    }
    gallery.pieces.push_back({std::move(drawing), {left, top, width, height}});
    gallery.height = std::max(gallery.height, top + height);
    left += width + kBetweenFigures / 2;
  }
  return gallery;
}

class PageWriter {
 public:
  explicit PageWriter(const std::string& made_utc) : file_{kPageWidth, kPageHeight} {
    file_.set_date(made_utc);
  }

  std::string write(const std::vector<Block>& blocks) {
    for (std::size_t i = 0; i < blocks.size(); ++i) write_block(blocks, i);
    number_page();
    return file_.finish();
  }

 private:
  void write_block(const std::vector<Block>& blocks, std::size_t index) {
    const auto& block = blocks[index];
    switch (block.kind) {
      case Block::Kind::Heading:
        write_heading(block, index + 1 < blocks.size() ? &blocks[index + 1] : nullptr);
        break;
      case Block::Kind::Table:
        write_table(block);
        break;
      case Block::Kind::Figure:
        write_figure(block);
        break;
      case Block::Kind::Item:
        write_lines(block.words, kIndent, block.tone, "\u2022");
        break;
      case Block::Kind::Term:
        keep_together(kTogether);
        write_lines("<b>" + block.words + "</b>", 0.0, block.tone);
        y_ -= kAfterParagraph;
        break;
      case Block::Kind::Paragraph:
        write_lines(block.words, 0.0, block.tone);
        break;
    }
  }

  static constexpr double kAfterParagraph = 4.0;

  /// Goes to the next page unless there is so much room on this one.
  void keep_together(double height) {
    if (y_ > kTop && y_ + height > kBottom) turn_page();
  }

  void turn_page() {
    number_page();
    file_.next_page();
    ++page_;
    y_ = kTop;
  }

  void number_page() {
    const SetText number{
        file_.context(), fmt::format("{}", page_), {.size = kCaption, .colour = "#5b6875"}, -1.0};
    number.paint((kPageWidth - number.width()) / 2, kBottom + 8.0 * kPoints);
  }

  void write_heading(const Block& block, const Block* next) {
    const auto& look = kHeadings.at(static_cast<std::size_t>(block.level - 1));
    const bool is_warning = block.tone == Tone::Warning;
    const SetText text{file_.context(),
                       block.words,
                       {.size = is_warning ? kBody + 1.0 : look.size,
                        .colour = is_warning ? "#1b2733" : "#08306b",
                        .is_bold = true},
                       kWidth - kIndent};
    y_ += y_ > kTop ? look.above : 0.0;
    keep_together(text.height() + look.below + height_wanted(next));
    if (!is_warning) add_to_outline(block);
    if (block.level == 1) file_.set_title(block.plain);
    tint(text.height() + look.below, block.tone);
    text.paint(kLeft + indent_of(block.tone), y_);
    y_ += text.height() + look.below;
  }

  /// What is not to be parted from the heading above it.
  double height_wanted(const Block* next) const {
    if (next == nullptr || next->kind != Block::Kind::Figure) return kTogether;
    return figure_height(*next, arrange(*next));
  }

  void add_to_outline(const Block& block) {
    const auto level = static_cast<std::size_t>(block.level);
    outline_.at(level) = file_.add_to_outline(block.plain, outline_.at(level - 1));
    for (auto deeper = level + 1; deeper < outline_.size(); ++deeper) {
      outline_.at(deeper) = outline_.at(level);
    }
  }

  static double indent_of(Tone tone) { return tone == Tone::Warning ? kIndent : 0.0; }

  /// The background of a warning, `height` down from here.
  void tint(double height, Tone tone) {
    if (tone != Tone::Warning) return;
    auto* const context = file_.context();
    set_colour(context, kWarningTint);
    cairo_rectangle(context, kLeft, y_ - 0.3, kWidth, height + 0.3);
    cairo_fill(context);
    set_colour(context, kWarningEdge);
    cairo_rectangle(context, kLeft, y_ - 0.3, 3.0, height + 0.3);
    cairo_fill(context);
  }

  /// Words over as many pages as they need; `bullet` stands before their first line.
  void write_lines(const Markup& words, double indent, Tone tone, const Markup& bullet = {}) {
    const double left = indent + indent_of(tone);
    const TextLook look{.size = tone == Tone::Soft ? kCaption : kBody,
                        .colour = tone == Tone::Soft ? "#5b6875" : "#1b2733"};
    const SetText text{file_.context(), words, look, kWidth - left};
    for (int line = 0; line < text.lines();) {
      const int end = lines_until(text, line);
      if (end == line) {
        turn_page();
        continue;
      }
      double height = end == text.lines() ? kAfterParagraph : 0.0;
      for (int k = line; k < end; ++k) height += text.line_height(k);
      tint(height, tone);
      if (line == 0) {
        SetText{file_.context(), bullet, look, -1.0}.paint(kLeft + left - kIndent + 2.0, y_);
      }
      paint_lines(text, line, end, kLeft + left);
      line = end;
    }
    y_ += kAfterParagraph;
  }

  /// The end of the lines, from this one, that have room on the page; none is to stand alone on
  /// the next.
  int lines_until(const SetText& text, int line) const {
    int end = line;
    for (double y = y_; end < text.lines(); ++end) {
      y += text.line_height(end);
      if (y > kBottom) break;
    }
    if (end == line && y_ == kTop) return line + 1;  // higher than a page: cut off
    const bool leaves_one = end == text.lines() - 1 && end - line > 2;
    return leaves_one ? end - 1 : end;
  }

  void paint_lines(const SetText& text, int from, int to, double x) {
    for (int line = from; line < to; ++line) {
      text.paint_line(line, x, y_);
      y_ += text.line_height(line);
    }
  }

  void write_table(const Block& block) {
    if (block.body.empty() && block.head.empty()) return;
    const SetTable table{file_.context(), block, kWidth};
    const double first = block.body.empty() ? 0.0 : table.height_of_row(0);
    keep_together(table.height_of_head() + first);
    begin_table(table);
    for (std::size_t row = 0; row < block.body.size(); ++row) {
      const double height = table.height_of_row(row);
      if (y_ + height > kBottom) {
        table.paint_end(kLeft, y_);
        turn_page();
        begin_table(table);
      }
      table.paint_row(row, kLeft, y_);
      y_ += height;
    }
    table.paint_end(kLeft, y_);
    y_ += 2 * kAfterParagraph;
  }

  void begin_table(const SetTable& table) {
    table.paint_head(kLeft, y_);
    y_ += table.height_of_head();
  }

  SetText caption_of(const Block& block) const {
    return {file_.context(), block.words, {.size = kCaption}, kWidth};
  }

  /// The drawings, with room for their caption on the same page.
  Gallery arrange(const Block& block) const {
    return arrange_drawings(block.drawings,
                            kBottom - kTop - caption_of(block).height() - 4 * kAfterParagraph);
  }

  double figure_height(const Block& block, const Gallery& gallery) const {
    return gallery.height + caption_of(block).height() + 4 * kAfterParagraph;
  }

  void write_figure(const Block& block) {
    const auto gallery = arrange(block);
    keep_together(figure_height(block, gallery));
    y_ += kAfterParagraph;
    for (const auto& piece : gallery.pieces) {
      auto place = piece.place;
      place.left += kLeft;
      place.top += y_;
      piece.drawing.paint(file_.context(), place);
    }
    y_ += gallery.height + kAfterParagraph;
    const auto caption = caption_of(block);
    if (!block.words.empty()) caption.paint(kLeft, y_);
    y_ += caption.height() + 2 * kAfterParagraph;
  }

  PdfFile file_;
  double y_ = kTop;
  int page_ = 1;
  std::array<int, 4> outline_{};  ///< the last entry of each level; [0]: the root
};

}  // namespace

std::string report_pdf(const std::string& page, const std::string& made_utc) {
  return PageWriter{made_utc}.write(read_blocks(page));
}

}  // namespace bimodal::analysis
