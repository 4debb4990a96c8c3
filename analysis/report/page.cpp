#include "analysis/report/page.hpp"

#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/report/page_parts.hpp"
#include "stimuli/base/markup.hpp"

namespace bimodal::analysis {

namespace {

std::string titles_of(const Dataset& dataset) {
  std::set<std::string> titles;
  for (const auto& session : dataset.sessions) titles.insert(session.protocol_title);
  if (titles.empty()) return "No sessions";
  return fmt::format("{}", fmt::join(titles, "; "));
}

std::string lead(const Results& results, const Making& making) {
  return fmt::format(
      "<p class='lead'>{} participant{}, {} trials in {} condition{}; {}. Made {} by {}.</p>\n",
      results.participants.size(),
      results.participants.size() == 1 ? "" : "s",
      results.dataset.trials.size(),
      results.conditions.size(),
      results.conditions.size() == 1 ? "" : "s",
      escaped(making.selection),
      escaped(making.made_utc),
      escaped(making.program));
}

}  // namespace

std::string report_page(const Results& results,
                        std::span<const Attachment> attachments,
                        const Making& making) {
  const auto title = escaped(titles_of(results.dataset));
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang='en'>\n<head>\n<meta charset='utf-8'/>\n"
      "<meta name='viewport' content='width=device-width, initial-scale=1'/>\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<h1>{}</h1>\n",
      title,
      page_style(),
      title);
  FigureNumbers numbers;
  page += lead(results, making);
  page += part_of_warnings(results);
  page += part_of_words(results, numbers);
  page += part_of_proportions(results);
  page += part_of_faces(results, numbers);
  page += part_of_benefits(results, numbers);
  page += part_of_attachments(attachments);
  page += part_of_confusions(results, numbers);
  page += part_of_features(results, numbers);
  page += part_of_structure(results, numbers);
  page += part_of_likeness(results);
  page += part_of_data(results);
  page += part_of_methods(results);
  page += part_for_paper(results, making);
  page += part_of_reproduction(results, making);
  page += part_of_trials(results);
  return page + "</body>\n</html>\n";
}

}  // namespace bimodal::analysis
