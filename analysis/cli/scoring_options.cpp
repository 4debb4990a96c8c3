#include "analysis/cli/scoring_options.hpp"

#include <functional>
#include <string>
#include <vector>

namespace bimodal::analysis {

namespace {

std::vector<std::string> tolerance_names() {
  std::vector<std::string> names;
  for (const Tolerance tolerance : kTolerances) names.emplace_back(name(tolerance));
  return names;
}

/// An option that is one of two values, named as name() names them.
template <typename Rule>
void add_choice(CLI::App& verb,
                const std::string& option,
                Rule& rule,
                Rule one,
                Rule other,
                const std::string& meaning) {
  const std::function<void(const std::string&)> choose = [&rule, one, other](const auto& chosen) {
    rule = chosen == name(one) ? one : other;
  };
  verb.add_option_function<std::string>(option, choose, meaning)
      ->check(CLI::IsMember({std::string{name(one)}, std::string{name(other)}}))
      ->default_str(std::string{name(rule)});
}

}  // namespace

void add_scoring_options(CLI::App& verb, ScoringRules& rules) {
  const std::function<void(const std::vector<std::string>&)> tolerate =
      [&rules](const std::vector<std::string>& names) {
        for (const auto& named : names) rules.tolerate(tolerance_from_name(named).value());
      };
  verb.add_option_function<std::vector<std::string>>(
          "--tolerate", tolerate, "Forgive answers this, separated by commas (may be repeated)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(tolerance_names()));
  verb.add_flag_callback(
      "--no-homophones",
      [&rules] { rules.homophones = false; },
      "A word of another spelling is wrong, however it sounds");
  add_choice(verb,
             "--out-of-dictionary",
             rules.out_of_dictionary,
             OutOfDictionary::LeftOut,
             OutOfDictionary::LetterToSound,
             "Phonemes of answers that the dictionary lacks: leave them out, or say the answers by "
             "letter-to-sound rules");
  add_choice(verb,
             "--costs",
             rules.costs,
             AlignmentCosts::Unit,
             AlignmentCosts::Feature,
             "Of aligning phones that differ: 1, or the share of their features that differ");
  add_choice(verb,
             "--ties",
             rules.ties,
             TieRule::LeftOut,
             TieRule::Averaged,
             "Phones on which equally good alignments disagree: leave them out of confusions, or "
             "let each alignment weigh the same");
}

}  // namespace bimodal::analysis
