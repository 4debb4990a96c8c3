#include "analysis/report/figure_files.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "analysis/report/figures.hpp"
#include "analysis/report/page_parts.hpp"

namespace bimodal::analysis {

namespace {

/// An SVG element of the page with its own name space and style, on white.
std::string standing_alone(std::string element) {
  constexpr std::string_view kOpening = "<svg ";
  element.insert(kOpening.size(), "xmlns='http://www.w3.org/2000/svg' ");
  element.insert(
      element.find('>') + 1,
      fmt::format("\n<style>{}\nsvg {{ font-family: sans-serif; background: #fff; }}</style>"
                  "\n<rect width='100%' height='100%' fill='#fff'/>",
                  page_style()));
  return element;
}

/// Conditions are free text; file names are not.
std::string as_file_name(std::string text) {
  std::ranges::replace_if(
      text,
      [](char letter) {
        const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                           (letter >= '0' && letter <= '9') || letter == '-' || letter == '_';
        return !plain;
      },
      '_');
  return text;
}

}  // namespace

std::vector<ReportFile> figure_files(const Results& results) {
  std::vector<ReportFile> files{
      {.name = "figures/words.svg", .content = standing_alone(figure_of_words(results))}};
  for (const auto& confusions : results.confusions) {
    files.push_back(
        {.name = fmt::format(
             "figures/{}-{}.svg", name(confusions.unit), as_file_name(confusions.condition)),
         .content = standing_alone(figure_of_confusions(confusions))});
  }
  return files;
}

}  // namespace bimodal::analysis
