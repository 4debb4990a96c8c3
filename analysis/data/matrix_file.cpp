#include "analysis/data/matrix_file.hpp"

#include "analysis/data/matrix_forms.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/labels/text_encoding.hpp"

namespace bimodal::analysis {

namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

bool is_utf16(std::string_view text) {
  return text.starts_with("\xfe\xff") || text.starts_with("\xff\xfe");
}

std::string_view without_mark(std::string_view text) {
  return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

bool is_praat(std::string_view text) {
  return text.starts_with("File type");
}

bool is_json(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

}  // namespace

TitledMatrix parse_titled_matrix(std::string_view text, std::string_view file) {
  const auto begin = without_mark(text);
  if (is_praat(begin)) return parse_praat_matrix(decode_text(text, file), file);
  if (is_utf16(text)) {
    const auto decoded = decode_text(text, file);
    if (is_praat(decoded)) return parse_praat_matrix(decoded, file);
  }
  return is_json(begin) ? parse_json_matrix(text, file) : parse_csv_matrix(text, file);
}

ConfusionMatrix parse_matrix(std::string_view text, std::string_view file) {
  return parse_titled_matrix(text, file).matrix;
}

TitledMatrix read_titled_matrix(const std::filesystem::path& file) {
  return parse_titled_matrix(read_file(file), file.string());
}

ConfusionMatrix read_matrix(const std::filesystem::path& file) {
  return read_titled_matrix(file).matrix;
}

}  // namespace bimodal::analysis
