#include "stimuli/labels/text_encoding.hpp"

#include <algorithm>

#include "stimuli/base/utf8.hpp"
#include "stimuli/labels/label_lines.hpp"

namespace bimodal {

namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr std::string_view kLittleEndianMark = "\xFF\xFE";
constexpr std::string_view kBigEndianMark = "\xFE\xFF";

/// Line of what follows the text.
std::size_t line_after(std::string_view text) {
  return 1 + static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

bool is_high_surrogate(char32_t unit) {
  return unit >= 0xD800U && unit < 0xDC00U;
}

bool is_low_surrogate(char32_t unit) {
  return unit >= 0xDC00U && unit < 0xE000U;
}

/// The Unicode Standard 15, section 3.9, D91.
std::string from_utf16(std::string_view bytes, bool big_endian, std::string_view file) {
  constexpr std::string_view kRemedy = "save it again, best as UTF-8";
  const auto unit_at = [&](std::size_t at) {
    const char32_t first = static_cast<unsigned char>(bytes[at]);
    const char32_t second = static_cast<unsigned char>(bytes[at + 1]);
    return big_endian ? (first << 8U) | second : (second << 8U) | first;
  };
  std::string text;
  text.reserve(bytes.size());
  std::size_t at = 0;
  while (at + 2 <= bytes.size()) {
    char32_t character = unit_at(at);
    at += 2;
    if (is_high_surrogate(character) && at + 2 <= bytes.size() && is_low_surrogate(unit_at(at))) {
      character = 0x10000U + ((character - 0xD800U) << 10U) + (unit_at(at) - 0xDC00U);
      at += 2;
    } else if (is_high_surrogate(character) || is_low_surrogate(character)) {
      refuse({file, line_after(text)}, "half of a UTF-16 surrogate pair stands alone", kRemedy);
    }
    append_utf8(text, character);
  }
  if (at != bytes.size()) {
    refuse({file, line_after(text)}, "the file is UTF-16 and ends within a character", kRemedy);
  }
  return text;
}

std::string from_latin1(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  for (const char byte : bytes) append_utf8(text, static_cast<unsigned char>(byte));
  return text;
}

std::string to_utf8(std::string_view bytes, std::string_view file) {
  if (bytes.starts_with(kLittleEndianMark)) return from_utf16(bytes.substr(2), false, file);
  if (bytes.starts_with(kBigEndianMark)) return from_utf16(bytes.substr(2), true, file);
  if (bytes.starts_with(kUtf8Mark)) bytes.remove_prefix(kUtf8Mark.size());
  return is_utf8(bytes) ? std::string{bytes} : from_latin1(bytes);
}

/// Lines that end in "\r\n" (Windows) or '\r' (old Macintosh) end in '\n'.
void unify_line_ends(std::string& text) {
  std::size_t kept = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool pair = text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n';
    if (pair) continue;
    text[kept] = text[at] == '\r' ? '\n' : text[at];
    ++kept;
  }
  text.resize(kept);
}

}  // namespace

std::string decode_text(std::string_view bytes, std::string_view file) {
  auto text = to_utf8(bytes, file);
  unify_line_ends(text);
  if (const auto nul = text.find('\0'); nul != std::string::npos) {
    refuse({file, line_after(std::string_view{text}.substr(0, nul))},
           "a NUL character: this is no text that we know",
           "save it as plain text in UTF-8");
  }
  return text;
}

}  // namespace bimodal
