#include "analysis/scoring/scoring_rules.hpp"

#include <fmt/format.h>

namespace bimodal::analysis {

namespace {

constexpr std::array<std::string_view, kTolerances.size()> kNames{
    "double-letters", "plural", "tense", "contractions", "numbers", "compounds"};

std::string list_of_tolerated(const ScoringRules& rules) {
  std::string list;
  for (const Tolerance tolerance : kTolerances) {
    if (!rules.tolerates(tolerance)) continue;
    if (!list.empty()) list += ", ";
    list += name(tolerance);
  }
  return list.empty() ? "nothing" : list;
}

}  // namespace

std::string_view name(Tolerance tolerance) {
  return kNames.at(static_cast<std::size_t>(tolerance));
}

std::optional<Tolerance> tolerance_from_name(std::string_view name) {
  for (const Tolerance tolerance : kTolerances) {
    if (analysis::name(tolerance) == name) return tolerance;
  }
  return std::nullopt;
}

std::string_view name(OutOfDictionary rule) {
  return rule == OutOfDictionary::LeftOut ? "leave-out" : "letter-to-sound";
}

std::string_view name(AlignmentCosts costs) {
  return costs == AlignmentCosts::Unit ? "unit" : "feature";
}

std::string_view name(TieRule rule) {
  return rule == TieRule::LeftOut ? "leave-out" : "average";
}

std::string describe_rules(const ScoringRules& rules) {
  return fmt::format(
      "Homophones {}. Tolerated: {}. Answers that are not in the dictionary are {}. Phones are "
      "aligned at {}; {}.",
      rules.homophones ? "count as correct" : "count as wrong",
      list_of_tolerated(rules),
      rules.out_of_dictionary == OutOfDictionary::LeftOut
          ? "left out of phoneme scores"
          : "said by letter-to-sound rules in phoneme scores",
      rules.costs == AlignmentCosts::Unit ? "unit costs" : "costs by phonetic features",
      rules.ties == TieRule::LeftOut
          ? "a phone on which equally good alignments disagree is left out of confusions"
          : "in confusions equally good alignments weigh the same");
}

}  // namespace bimodal::analysis
