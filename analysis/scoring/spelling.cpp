#include "analysis/scoring/spelling.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace bimodal::analysis {

namespace {

/// Code points first..last are all written `folded`.
struct Folding {
  char32_t first;
  char32_t last;
  std::string_view folded;
};

/// In ascending order; a code point in none of the ranges stays as it is. Latin letters are those
/// of Unicode blocks "Latin-1 Supplement" and "Latin Extended-A".
constexpr std::array kFoldings = std::to_array<Folding>({
    {0x0000, 0x0026, ""},   {0x0027, 0x0027, "'"},  {0x0028, 0x002f, ""},   {0x003a, 0x0040, ""},
    {0x005b, 0x005f, ""},   {0x0060, 0x0060, "'"},  {0x007b, 0x00a9, ""},   {0x00aa, 0x00aa, "a"},
    {0x00ab, 0x00b3, ""},   {0x00b4, 0x00b4, "'"},  {0x00b5, 0x00b9, ""},   {0x00ba, 0x00ba, "o"},
    {0x00bb, 0x00bf, ""},   {0x00c0, 0x00c5, "a"},  {0x00c6, 0x00c6, "ae"}, {0x00c7, 0x00c7, "c"},
    {0x00c8, 0x00cb, "e"},  {0x00cc, 0x00cf, "i"},  {0x00d0, 0x00d0, "d"},  {0x00d1, 0x00d1, "n"},
    {0x00d2, 0x00d6, "o"},  {0x00d7, 0x00d7, ""},   {0x00d8, 0x00d8, "o"},  {0x00d9, 0x00dc, "u"},
    {0x00dd, 0x00dd, "y"},  {0x00de, 0x00de, "th"}, {0x00df, 0x00df, "ss"}, {0x00e0, 0x00e5, "a"},
    {0x00e6, 0x00e6, "ae"}, {0x00e7, 0x00e7, "c"},  {0x00e8, 0x00eb, "e"},  {0x00ec, 0x00ef, "i"},
    {0x00f0, 0x00f0, "d"},  {0x00f1, 0x00f1, "n"},  {0x00f2, 0x00f6, "o"},  {0x00f7, 0x00f7, ""},
    {0x00f8, 0x00f8, "o"},  {0x00f9, 0x00fc, "u"},  {0x00fd, 0x00fd, "y"},  {0x00fe, 0x00fe, "th"},
    {0x00ff, 0x00ff, "y"},  {0x0100, 0x0105, "a"},  {0x0106, 0x010d, "c"},  {0x010e, 0x0111, "d"},
    {0x0112, 0x011b, "e"},  {0x011c, 0x0123, "g"},  {0x0124, 0x0127, "h"},  {0x0128, 0x0131, "i"},
    {0x0132, 0x0133, "ij"}, {0x0134, 0x0135, "j"},  {0x0136, 0x0138, "k"},  {0x0139, 0x0142, "l"},
    {0x0143, 0x0148, "n"},  {0x0149, 0x0149, "'n"}, {0x014a, 0x014b, "ng"}, {0x014c, 0x0151, "o"},
    {0x0152, 0x0153, "oe"}, {0x0154, 0x0159, "r"},  {0x015a, 0x0161, "s"},  {0x0162, 0x0167, "t"},
    {0x0168, 0x0173, "u"},  {0x0174, 0x0175, "w"},  {0x0176, 0x0178, "y"},  {0x0179, 0x017e, "z"},
    {0x017f, 0x017f, "s"},  {0x02b9, 0x02bf, "'"},  {0x0300, 0x036f, ""},   {0x2000, 0x2017, ""},
    {0x2018, 0x201b, "'"},  {0x201c, 0x2031, ""},   {0x2032, 0x2032, "'"},  {0x2033, 0x206f, ""},
    {0x3000, 0x303f, ""},   {0xfeff, 0xfeff, ""},
});

constexpr bool ascending() {
  char32_t next = 0;
  for (const auto& folding : kFoldings) {
    if (folding.first < next || folding.last < folding.first) return false;
    next = folding.last + 1;
  }
  return true;
}

static_assert(ascending());

struct Decoded {
  char32_t code_point = 0xfffd;  ///< the replacement character where the bytes are not UTF-8
  std::size_t bytes = 1;
};

Decoded decode(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return {};
  char32_t code_point = lead & (0xffU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xc0U) != 0x80U) return {};
    code_point = (code_point << 6U) | (next & 0x3fU);
  }
  return {code_point, length};
}

void append_folded(std::string_view letter, char32_t code_point, std::string& folded) {
  if (code_point >= U'A' && code_point <= U'Z') {
    folded += static_cast<char>(code_point - U'A' + U'a');
    return;
  }
  const auto* const found =
      std::ranges::upper_bound(kFoldings, code_point, std::less<>{}, &Folding::first);
  if (found != kFoldings.begin() && std::prev(found)->last >= code_point) {
    folded += std::prev(found)->folded;
    return;
  }
  folded += letter;
}

}  // namespace

std::string fold_spelling(std::string_view utf8) {
  std::string folded;
  while (!utf8.empty()) {
    const auto [code_point, bytes] = decode(utf8);
    append_folded(utf8.substr(0, bytes), code_point, folded);
    utf8.remove_prefix(bytes);
  }
  const auto first = folded.find_first_not_of('\'');
  if (first == std::string::npos) return {};
  return folded.substr(first, folded.find_last_not_of('\'') - first + 1);
}

}  // namespace bimodal::analysis
