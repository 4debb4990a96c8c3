#include "analysis/report/printed_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

/// Makes what follows smaller where it would run off the page; ends with "}".
constexpr std::string_view kNoWiderThanText =
    "\\resizebox{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}{!}{%\n";

constexpr std::string_view kMarkdownSpecials = R"(\`*_{}[]<>#|~&!$)";

std::string latex_letter(char letter) {
  switch (letter) {
    case '\\':
      return R"(\textbackslash{})";
    case '~':
      return R"(\textasciitilde{})";
    case '^':
      return R"(\textasciicircum{})";
    case '<':
      return R"(\textless{})";
    case '>':
      return R"(\textgreater{})";
    case '|':
      return R"(\textbar{})";
    case '[':
      return "{[}";  // behind \\ or \toprule it would begin an option
    case '{':
    case '}':
    case '$':
    case '&':
    case '#':
    case '_':
    case '%':
      return fmt::format("\\{}", letter);
    default:
      return std::string(1, letter);
  }
}

std::string latex(std::string_view text) {
  std::string escaped;
  for (const char letter : text) escaped += latex_letter(letter);
  return escaped;
}

std::string markdown(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    if (kMarkdownSpecials.find(letter) != std::string_view::npos) escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

/// Of counts in parts two decimals.
std::string printed_count(double count) {
  return std::trunc(count) == count ? fmt::format("{}", count) : fmt::format("{:.2f}", count);
}

std::string cell(const ConfusionMatrix& matrix, std::size_t row, std::size_t column) {
  const auto count = matrix.count(row, column);
  if (count == 0.0) return "0";
  return fmt::format(
      "{} ({})", printed_count(count), print_proportion(matrix.proportion(row, column).value()));
}

std::string note(const ExportedMatrix& exported) {
  auto text = fmt::format(
      "Rows are stimuli, columns are responses: counts, and in brackets proportions of the row. n: "
      "responses in the row, {} in all. Order: {}.",
      printed_count(exported.matrix.total()),
      in_words(exported.order));
  auto trials = provenance_text(exported.provenance);
  std::ranges::replace(trials, '\n', ' ');
  if (!trials.empty()) text += " " + trials.substr(0, trials.size() - 1);
  for (const auto& warning : exported.warnings) text += fmt::format(" Warning: {}.", warning);
  return text;
}

/// The fields of a row: stimulus, a cell for each response, n.
std::vector<std::string> row_fields(const ConfusionMatrix& matrix,
                                    std::size_t row,
                                    std::string stimulus) {
  std::vector<std::string> fields{std::move(stimulus)};
  for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
    fields.push_back(cell(matrix, row, j));
  }
  fields.push_back(printed_count(matrix.row_total(row)));
  return fields;
}

}  // namespace

std::string matrix_latex(const ExportedMatrix& exported) {
  const auto& matrix = exported.matrix;
  const auto columns = matrix.responses().size();
  std::string table =
      "% needs \\usepackage{booktabs,graphicx}; phonetic letters need XeLaTeX or LuaLaTeX\n"
      "\\begin{table}\n\\refstepcounter{table}\n\\textbf{Table \\thetable}\\par\\medskip\n";
  table += fmt::format("\\textit{{{}}}\\par\\medskip\n", latex(exported.title));
  table += kNoWiderThanText;
  table += fmt::format("\\begin{{tabular}}{{l*{{{}}}{{r}}r}}\n\\toprule\n", columns);
  std::vector<std::string> fields{"Stimulus"};
  for (const auto& response : matrix.responses()) fields.push_back(latex(response));
  fields.emplace_back("\\textit{n}");
  table += fmt::format("{} \\\\\n\\midrule\n", fmt::join(fields, " & "));
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    fields = row_fields(matrix, i, latex(matrix.stimuli()[i]));
    table += fmt::format("{} \\\\\n", fmt::join(fields, " & "));
  }
  table += fmt::format(
      "\\bottomrule\n\\end{{tabular}}}}\n\\par\\medskip\n\\textit{{Note.}} {}\n\\end{{table}}\n",
      latex(note(exported)));
  return table;
}

std::string matrix_markdown(const ExportedMatrix& exported) {
  const auto& matrix = exported.matrix;
  std::string table = fmt::format("**{}**\n\n", markdown(exported.title));
  std::vector<std::string> fields{"Stimulus"};
  for (const auto& response : matrix.responses()) fields.push_back(markdown(response));
  fields.emplace_back("*n*");
  table += fmt::format("| {} |\n| :--- |", fmt::join(fields, " | "));
  for (std::size_t i = 1; i < fields.size(); ++i) table += " ---: |";
  table += '\n';
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    fields = row_fields(matrix, i, markdown(matrix.stimuli()[i]));
    table += fmt::format("| {} |\n", fmt::join(fields, " | "));
  }
  table += fmt::format("\n*Note.* {}\n", markdown(note(exported)));
  return table;
}

}  // namespace bimodal::analysis
