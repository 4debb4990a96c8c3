#pragma once

#include <string>
#include <vector>

namespace bimodal::analysis {

/// Words of the page as Pango's markup; white space is as HTML shows it.
using Markup = std::string;

/// How much a block of the page is to be noticed.
enum class Tone { Plain, Soft, Warning };

struct TableCell {
  Markup words;
  bool is_number = false;   ///< set at the right, in one line
  bool is_heading = false;  ///< of its row or column
};

struct TableRow {
  std::vector<TableCell> cells;
  bool begins_group = false;  ///< a thin rule above it
};

/// One piece of the page, in its order.
struct Block {
  enum class Kind { Heading, Paragraph, Item, Term, Table, Figure };

  Kind kind = Kind::Paragraph;
  Tone tone = Tone::Plain;
  int level = 1;      ///< of a heading, 1 to 3
  Markup words;       ///< of a figure: its caption
  std::string plain;  ///< of a heading: its words without markup
  std::vector<TableRow> head;
  std::vector<TableRow> body;
  std::vector<std::string> drawings;  ///< of a figure: SVG documents, side by side
};

/// What there is to print of a page that is well-formed XML: headings, paragraphs, lists, tables
/// and figures. Not: closed <details>, sounds (their caption says so), scripts and styles. Throws
/// Error if it is not well-formed.
[[nodiscard]] std::vector<Block> read_blocks(const std::string& page);

}  // namespace bimodal::analysis
