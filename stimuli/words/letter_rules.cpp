#include "stimuli/words/letter_rules.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "stimuli/base/diagnostic.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/words/letter_context.hpp"

namespace bimodal {

namespace {

constexpr std::string_view kHeader = "group\tindex\tleft\ttext\tright\tphonemes";
constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr std::string_view kDigits = "0123456789";

struct PauseSymbol {
  std::string_view symbol;
  Pause pause;
};

constexpr std::array<PauseSymbol, 5> kPauses{{
    {"< >", Pause::None},
    {"<->", Pause::Dash},
    {"<,>", Pause::Comma},
    {"<.>", Pause::Stop},
    {"<?>", Pause::Question},
}};

bool has(std::string_view letters, char letter) {
  return letters.find(letter) != std::string_view::npos;
}

/// A mistake on one line.
struct Mistake {
  std::string finding;
  std::string remedy;
};

std::array<std::string_view, 6> columns_of(std::string_view line) {
  std::array<std::string_view, 6> columns;
  if (std::ranges::count(line, '\t') != 5) {
    throw Mistake{"there are not six columns",
                  "separate group, index, left, text, right and phonemes by tabs"};
  }
  for (auto& column : columns) {
    column = line.substr(0, line.find('\t'));
    line.remove_prefix(std::min(column.size() + 1, line.size()));
  }
  return columns;
}

std::string_view group_of(char first) {
  if (has(kLetters, first)) return kLetters.substr(kLetters.find(first), 1);
  return has(kDigits, first) ? "NUMBER" : "PUNCT";
}

void judge_letters(std::string_view letters, std::string_view group) {
  const auto is_readable = [](char letter) {
    return letter == ' ' || has(kLetters, letter) || has(kDigits, letter) ||
           has(kRulePunctuation, letter);
  };
  if (letters.empty() || !std::ranges::all_of(letters, is_readable)) {
    throw Mistake{fmt::format("\"{}\" is no text for a rule", letters),
                  "write capital letters, digits, blanks or ' - , . ?"};
  }
  if (group != group_of(letters.front())) {
    throw Mistake{fmt::format("a rule for \"{}\" is no rule of group {}", letters, group),
                  fmt::format("put it into group {}", group_of(letters.front()))};
  }
}

void judge_context(std::string_view context) {
  if (std::ranges::all_of(context, is_of_context)) return;
  throw Mistake{fmt::format("\"{}\" is no context", context),
                "write capital letters, blanks, apostrophes or # * : ^ $ . + & @ %"};
}

/// What stands between the slashes.
std::string_view between_slashes(std::string_view phonemes) {
  if (phonemes.size() < 2 || !phonemes.starts_with('/') || !phonemes.ends_with('/')) {
    throw Mistake{fmt::format("the phonemes \"{}\" do not stand between slashes", phonemes),
                  "write e.g. \"/AA R/\", or \"/ /\" for nothing"};
  }
  return phonemes.substr(1, phonemes.size() - 2);
}

Pronunciation phones_of(std::string_view symbols) {
  Pronunciation phones;
  while (!symbols.empty()) {
    const auto symbol = symbols.substr(0, symbols.find(' '));
    symbols.remove_prefix(std::min(symbol.size() + 1, symbols.size()));
    if (symbol.empty()) continue;
    const auto phone = symbol == "NX" ? Phone::NG : phone_from_symbol(symbol);
    if (!phone || *phone == Phone::Rest) {
      throw Mistake{fmt::format("\"{}\" is not a phone", symbol),
                    fmt::format("use the symbols {}", spell(all_phones().subspan(1)))};
    }
    phones.push_back(*phone);
  }
  return phones;
}

LetterRule rule_of(std::string_view line, std::map<std::string, int, std::less<>>& counts) {
  const auto [group, index, left, letters, right, phonemes] = columns_of(line);
  judge_letters(letters, group);
  judge_context(left);
  judge_context(right);
  const auto place = ++counts[std::string{group}];
  if (index != std::to_string(place)) {
    throw Mistake{fmt::format("the index is \"{}\" in place {} of group {}", index, place, group),
                  "number the rules of a group from 1, without gaps"};
  }
  LetterRule rule{.name = fmt::format("{}{}", group, index),
                  .left = context_before(left),
                  .letters = std::string{letters},
                  .right = context_after(right),
                  .phones = {},
                  .ends = {}};
  const auto said = between_slashes(phonemes);
  const auto* const pause = std::ranges::find(kPauses, said, &PauseSymbol::symbol);
  if (pause != kPauses.end()) {
    rule.ends = pause->pause;
  } else {
    rule.phones = phones_of(said);
  }
  return rule;
}

/// The letters and digits that would be unreadable in some context.
std::string without_last_resort(const std::vector<LetterRule>& rules) {
  std::string missing;
  for (const auto letters : {kLetters, kDigits}) {
    for (const char letter : letters) {
      const bool covered = std::ranges::any_of(rules, [&](const LetterRule& rule) {
        return rule.left.empty() && rule.right.empty() && rule.letters == std::string{letter};
      });
      if (!covered) missing += letter;
    }
  }
  return missing;
}

}  // namespace

std::vector<LetterRule> parse_letter_rules(std::string_view content, const std::string& file) {
  std::vector<LetterRule> rules;
  std::vector<std::string> mistakes;
  const auto find = [&](std::size_t line, std::string finding, std::string remedy) {
    mistakes.push_back(describe(Diagnostic{.file = file,
                                           .line = line,
                                           .pointer = {},
                                           .finding = std::move(finding),
                                           .remedy = std::move(remedy)}));
  };
  std::map<std::string, int, std::less<>> counts;
  for (std::size_t number = 1; !content.empty(); ++number) {
    auto line = content.substr(0, content.find('\n'));
    content.remove_prefix(std::min(line.size() + 1, content.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    try {
      if (number > 1) {
        rules.push_back(rule_of(line, counts));
      } else if (line != kHeader) {
        throw Mistake{"the first line does not name the columns", fmt::format("write {}", kHeader)};
      }
    } catch (Mistake& mistake) {
      find(number, std::move(mistake.finding), std::move(mistake.remedy));
    }
  }
  if (const auto missing = without_last_resort(rules); mistakes.empty() && !missing.empty()) {
    find(0,
         fmt::format("there is no rule without contexts for {}", missing),
         "end the group of every letter and digit with one");
  }
  if (!mistakes.empty()) throw Error{fmt::format("{}", fmt::join(mistakes, "\n"))};
  return rules;
}

std::vector<LetterRule> read_letter_rules(const std::filesystem::path& file) {
  return parse_letter_rules(read_file(file), file.string());
}

}  // namespace bimodal
