#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analysis/data/matrix_forms.hpp"
#include "analysis/data/matrix_parts.hpp"
#include "stimuli/labels/praat_text.hpp"

namespace bimodal::analysis {

namespace {

constexpr std::array<std::string_view, 3> kClasses{"Confusion", "ContingencyTable", "TableOfReal"};

void require_table(PraatText& praat) {
  if (!praat.take_string("the type of the file").starts_with("ooTextFile")) {
    refuse(praat.line(), "this is no text file of Praat", "save it as a text file from Praat");
  }
  const auto found = praat.take_string("the class of the object");
  if (std::ranges::find(kClasses, found) != kClasses.end()) return;
  refuse(praat.line(),
         fmt::format("the object is a {}, no Confusion", in_quotes(found)),
         "save a Confusion, a ContingencyTable or a TableOfReal");
}

std::size_t take_size(PraatText& praat, std::string_view what) {
  const auto size = praat.take_count(what);
  if (size == 0) refuse(praat.line(), fmt::format("{} is 0", what), "is this the right file?");
  return size;
}

/// The lines between the head and the table that are comments to Praat ("! ..."), without that
/// mark.
std::vector<std::string> remarks_in(std::string_view text) {
  constexpr std::string_view kMark = "! ";
  constexpr std::string_view kTable = "numberOfColumns";
  std::vector<std::string> remarks;
  LineReader lines{text};
  while (const auto line = lines.next()) {
    if (line->starts_with(kTable)) return remarks;
    if (line->starts_with(kMark)) remarks.emplace_back(line->substr(kMark.size()));
  }
  return {};
}

}  // namespace

TitledMatrix parse_praat_matrix(std::string_view text, std::string_view file) {
  PraatText praat{text, file};
  const Refusal refuse_here = [&praat](std::string_view finding, std::string_view remedy) {
    refuse(praat.line(), finding, remedy);
  };
  require_table(praat);
  LabelAxis responses{"response"};
  for (auto columns = take_size(praat, "the number of columns"); columns > 0; --columns) {
    responses.add(praat.take_string("the label of a column"), refuse_here);
  }
  LabelAxis stimuli{"stimulus"};
  std::vector<double> counts;
  for (auto rows = take_size(praat, "the number of rows"); rows > 0; --rows) {
    stimuli.add(praat.take_string("the label of a row"), refuse_here);
    for (const auto& response : responses.labels()) {
      const auto count = praat.take_number("a count");
      if (!is_matrix_count(count)) {
        refuse_here(fmt::format(R"({}, the response "{}" to "{}", is no count)",
                                count,
                                response,
                                stimuli.labels().back()),
                    kCountRemedy);
      }
      counts.push_back(count);
    }
  }
  if (!praat.at_end()) {
    refuse_here("something follows the last row", "save the Confusion alone");
  }
  return titled({stimuli.labels(), responses.labels(), std::move(counts)}, remarks_in(text));
}

}  // namespace bimodal::analysis
