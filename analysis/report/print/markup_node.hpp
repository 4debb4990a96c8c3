#pragma once

#include <string>
#include <string_view>

#include <libxml/tree.h>

namespace bimodal::analysis {

/// An element's name; empty for text and all else.
[[nodiscard]] std::string_view element_name(const xmlNode* node);

/// Empty if there is none.
[[nodiscard]] std::string attribute(const xmlNode* node, const char* name);

/// Whether one of the element's classes is this one.
[[nodiscard]] bool has_class(const xmlNode* node, std::string_view name);

/// Whether it stands within a line: text, or an element such as <b>.
[[nodiscard]] bool is_inline(const xmlNode* node);

/// What it contains as Pango's markup.
[[nodiscard]] std::string inline_markup(const xmlNode* node);

/// The markup with white space as HTML shows it: none at the ends, one space elsewhere.
[[nodiscard]] std::string without_extra_space(std::string_view markup);

/// The element itself as XML.
[[nodiscard]] std::string as_xml(const xmlNode* node);

/// Its text alone.
[[nodiscard]] std::string text_of(const xmlNode* node);

}  // namespace bimodal::analysis
