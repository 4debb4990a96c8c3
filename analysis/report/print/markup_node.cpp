#include "analysis/report/print/markup_node.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include <fmt/format.h>

#include "stimuli/base/markup.hpp"

namespace bimodal::analysis {

namespace {

struct FreeText {
  void operator()(xmlChar* text) const { xmlFree(text); }
};

using XmlText = std::unique_ptr<xmlChar, FreeText>;

std::string as_string(const xmlChar* text) {
  return text == nullptr ? std::string{} : reinterpret_cast<const char*>(text);
}

/// How an element within a line shows: what stands before and after its content.
struct Inline {
  std::string_view element;
  std::string_view before;
  std::string_view after;
};

constexpr std::array kInline = std::to_array<Inline>({{"b", "<b>", "</b>"},
                                                      {"strong", "<b>", "</b>"},
                                                      {"i", "<i>", "</i>"},
                                                      {"em", "<i>", "</i>"},
                                                      {"code", "<tt>", "</tt>"},
                                                      {"sub", "<sub>", "</sub>"},
                                                      {"sup", "<sup>", "</sup>"},
                                                      {"a", "", ""},
                                                      {"span", "", ""},
                                                      {"br", "\v", ""}});

const Inline* find_inline(const xmlNode* node) {
  const auto* const found = std::ranges::find(kInline, element_name(node), &Inline::element);
  return found == kInline.end() ? nullptr : found;
}

}  // namespace

std::string_view element_name(const xmlNode* node) {
  if (node == nullptr || node->type != XML_ELEMENT_NODE) return {};
  return reinterpret_cast<const char*>(node->name);
}

std::string attribute(const xmlNode* node, const char* name) {
  const XmlText value{xmlGetProp(node, reinterpret_cast<const xmlChar*>(name))};
  return as_string(value.get());
}

bool has_class(const xmlNode* node, std::string_view name) {
  const auto classes = " " + attribute(node, "class") + " ";
  return classes.find(fmt::format(" {} ", name)) != std::string::npos;
}

bool is_inline(const xmlNode* node) {
  return node->type == XML_TEXT_NODE || find_inline(node) != nullptr;
}

std::string inline_markup(const xmlNode* node) {
  if (node->type == XML_TEXT_NODE) return escaped(as_string(node->content));
  std::string markup;
  const auto* const shown = find_inline(node);
  const bool is_note = has_class(node, "note");
  if (shown != nullptr) markup += shown->before;
  if (is_note) markup += "<span foreground='#5b6875'>";
  for (const auto* child = node->children; child != nullptr; child = child->next) {
    markup += inline_markup(child);
  }
  if (is_note) markup += "</span>";
  if (shown != nullptr) markup += shown->after;
  return markup;
}

std::string without_extra_space(std::string_view markup) {
  std::string text;
  bool is_space = true;
  for (const char letter : markup) {
    const bool space = letter == ' ' || letter == '\n' || letter == '\t' || letter == '\r';
    if (letter == '\v') {  // <br/>
      text += '\n';
      is_space = true;
    } else if (!space) {
      text += letter;
      is_space = false;
    } else if (!is_space) {
      text += ' ';
      is_space = true;
    }
  }
  while (text.ends_with(' ') || text.ends_with('\n')) text.pop_back();
  return text;
}

std::string as_xml(const xmlNode* node) {
  const std::unique_ptr<xmlBuffer, void (*)(xmlBuffer*)> buffer{xmlBufferCreate(), &xmlBufferFree};
  xmlNodeDump(buffer.get(), node->doc, const_cast<xmlNode*>(node), 0, 0);
  return as_string(xmlBufferContent(buffer.get()));
}

std::string text_of(const xmlNode* node) {
  const XmlText text{xmlNodeGetContent(node)};
  return without_extra_space(as_string(text.get()));
}

}  // namespace bimodal::analysis
