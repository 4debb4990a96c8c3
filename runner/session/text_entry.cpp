#include "runner/session/text_entry.hpp"

#include <array>
#include <cstdint>

namespace bimodal::runner {

namespace {

constexpr bool is_continuation(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U;
}

/// Bytes of the well-formed code point that `utf8` begins with (RFC 3629); 0 if there is none.
std::size_t leading_code_point(std::string_view utf8) {
  const auto first = static_cast<unsigned char>(utf8.front());
  if (first < 0x80U) return 1;
  const std::size_t size = first >= 0xf0U ? 4 : first >= 0xe0U ? 3 : 2;
  if (first < 0xc2U || first > 0xf4U || utf8.size() < size) return 0;
  std::uint32_t value = first & (0xffU >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if (!is_continuation(utf8[i])) return 0;
    value = (value << 6U) | (static_cast<unsigned char>(utf8[i]) & 0x3fU);
  }
  constexpr std::array<std::uint32_t, 5> kSmallest{0, 0, 0x80U, 0x800U, 0x10000U};
  const bool surrogate = value >= 0xd800U && value <= 0xdfffU;
  return value < kSmallest.at(size) || value > 0x10ffffU || surrogate ? 0 : size;
}

constexpr bool is_control(std::string_view code_point) {
  const auto first = static_cast<unsigned char>(code_point.front());
  return code_point.size() == 1 && (first < 0x20U || first == 0x7fU);
}

}  // namespace

void TextEntry::type(std::string_view utf8) {
  while (!utf8.empty()) {
    const std::size_t size = leading_code_point(utf8);
    const auto code_point = utf8.substr(0, size == 0 ? 1 : size);
    utf8.remove_prefix(code_point.size());
    if (size == 0 || is_control(code_point) || length_ == longest_) continue;
    text_ += code_point;
    ++length_;
  }
}

void TextEntry::erase() {
  if (text_.empty()) return;
  while (is_continuation(text_.back())) text_.pop_back();
  text_.pop_back();
  --length_;
}

}  // namespace bimodal::runner
