#include "analysis/report/print/blocks.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <libxml/parser.h>

#include "analysis/report/figures/svg.hpp"
#include "analysis/report/print/markup_node.hpp"
#include "analysis/report/print/picture.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::analysis {

namespace {

constexpr std::array<std::string_view, 5> kNotPrinted{"head", "script", "style", "audio", "nav"};

Tone tone_of(const xmlNode* node, Tone around) {
  if (has_class(node, "warnings") || has_class(node, "simulated")) return Tone::Warning;
  if (around != Tone::Warning && (has_class(node, "note") || has_class(node, "lead"))) {
    return Tone::Soft;
  }
  return around;
}

TableRow read_row(const xmlNode* row) {
  TableRow read{.cells = {}, .begins_group = has_class(row, "first")};
  for (const auto* cell = row->children; cell != nullptr; cell = cell->next) {
    const auto name = element_name(cell);
    if (name != "td" && name != "th") continue;
    read.cells.push_back({.words = without_extra_space(inline_markup(cell)),
                          .is_number = has_class(cell, "number") || has_class(cell, "estimate"),
                          .is_heading = name == "th"});
  }
  return read;
}

void read_rows(const xmlNode* node, bool in_head, Block& table) {
  for (const auto* child = node->children; child != nullptr; child = child->next) {
    const auto name = element_name(child);
    if (name == "tr") {
      (in_head ? table.head : table.body).push_back(read_row(child));
    } else if (name == "thead" || name == "tbody" || name == "tfoot") {
      read_rows(child, name == "thead", table);
    }
  }
}

void read_figure(const xmlNode* node, Block& figure) {
  const auto name = element_name(node);
  if (name == "svg") {
    figure.drawings.push_back(standing_alone(as_xml(node)));
  } else if (name == "img") {
    figure.drawings.push_back(drawing_of_picture(attribute(node, "src")));
  } else if (name == "audio") {
    figure.words += "<i>A sound, to be heard in report.html:</i> ";
  } else if (name == "figcaption") {
    figure.words += without_extra_space(inline_markup(node));
  } else {
    for (const auto* child = node->children; child != nullptr; child = child->next) {
      read_figure(child, figure);
    }
  }
}

class Reader {
 public:
  void read_children(const xmlNode* node, Tone tone) {
    std::string line;
    for (const auto* child = node->children; child != nullptr; child = child->next) {
      if (is_inline(child)) {
        line += inline_markup(child);
        continue;
      }
      add_words(Block::Kind::Paragraph, std::exchange(line, {}), tone);
      read(child, tone_of(child, tone));
    }
    add_words(Block::Kind::Paragraph, line, tone);
  }

  std::vector<Block> finish() { return std::move(blocks_); }

 private:
  void add_words(Block::Kind kind, std::string_view markup, Tone tone) {
    auto words = without_extra_space(markup);
    if (words.empty()) return;
    auto& block = blocks_.emplace_back();
    block.kind = kind;
    block.tone = tone;
    block.words = std::move(words);
  }

  void add_heading(const xmlNode* node, int level, Tone tone) {
    add_words(Block::Kind::Heading, inline_markup(node), tone);
    if (blocks_.empty() || blocks_.back().kind != Block::Kind::Heading) return;
    blocks_.back().level = level;
    blocks_.back().plain = text_of(node);
  }

  void add_figure(const xmlNode* node) {
    auto& block = blocks_.emplace_back();
    block.kind = Block::Kind::Figure;
    read_figure(node, block);
  }

  /// Above the table, in bold.
  void add_caption(const xmlNode* table, Tone tone) {
    for (const auto* child = table->children; child != nullptr; child = child->next) {
      if (element_name(child) == "caption") {
        add_words(Block::Kind::Term, inline_markup(child), tone);
      }
    }
  }

  void read(const xmlNode* node, Tone tone) {
    const auto name = element_name(node);
    if (name.empty() || std::ranges::find(kNotPrinted, name) != kNotPrinted.end()) return;
    if (name.size() == 2 && name[0] == 'h' && name[1] >= '1' && name[1] <= '6') {
      add_heading(node, std::min(name[1] - '0', 3), tone);
    } else if (name == "figure" || name == "svg") {
      add_figure(node);
    } else if (name == "table") {
      add_caption(node, tone);
      auto& block = blocks_.emplace_back();
      block.kind = Block::Kind::Table;
      read_rows(node, false, block);
    } else if (name == "li") {
      add_words(Block::Kind::Item, inline_markup(node), tone);
    } else if (name == "dt") {
      add_words(Block::Kind::Term, inline_markup(node), tone);
    } else if (name != "details" || !attribute(node, "open").empty()) {
      read_children(node, tone);
    }
  }

  std::vector<Block> blocks_;
};

}  // namespace

std::vector<Block> read_blocks(const std::string& page) {
  const std::unique_ptr<xmlDoc, void (*)(xmlDoc*)> document{
      xmlReadMemory(page.data(),
                    static_cast<int>(page.size()),
                    "report.html",
                    "UTF-8",
                    XML_PARSE_NONET | XML_PARSE_HUGE | XML_PARSE_NOERROR | XML_PARSE_NOWARNING),
      &xmlFreeDoc};
  if (!document) {
    const auto* const fault = xmlGetLastError();
    throw Error{
        fmt::format("making the PDF of the report: the page is not well-formed: line {}: {}",
                    fault == nullptr ? 0 : fault->line,
                    fault == nullptr ? "?" : fault->message)};
  }
  Reader reader;
  reader.read_children(xmlDocGetRootElement(document.get()), Tone::Plain);
  return reader.finish();
}

}  // namespace bimodal::analysis
