#include "stimuli/words/letter_context.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace bimodal {

namespace {

constexpr std::size_t kMany = std::numeric_limits<std::size_t>::max();
constexpr std::string_view kVowels = "AEIOUY";
constexpr std::string_view kConsonants = "BCDFGHJKLMNPQRSTVWXZ";

/// The second half of "$", which is "^" and then this. No context has small letters.
constexpr char kEOrI = 'e';

/// A symbol that takes between `least` and `most` of some letters.
struct LetterClass {
  char symbol;
  std::string_view letters;
  std::size_t least;
  std::size_t most;
};

constexpr std::array<LetterClass, 9> kClasses{{
    {'#', kVowels, 1, kMany},
    {'*', kConsonants, 1, kMany},
    {':', kConsonants, 0, kMany},
    {'^', kConsonants, 1, 1},
    {'.', "BDVGJLMNRWZ", 1, 1},
    {'+', "EIY", 1, 1},
    {'&', "SCGZXJ", 1, 1},
    {'@', "TSRDLZNJ", 1, 1},
    {kEOrI, "EI", 1, 1},
}};

/// What a symbol may also take.
struct LetterGroup {
  char symbol;
  std::string_view letters;
};

constexpr std::array<LetterGroup, 10> kGroups{{
    {'&', "CH"},
    {'&', "SH"},
    {'@', "TH"},
    {'@', "CH"},
    {'@', "SH"},
    {'%', "ER "},
    {'%', "E "},
    {'%', "ES "},
    {'%', "ED "},
    {'%', "ING "},
}};

/// The letters on one side of a place in the text, counted outwards from it.
class Outwards {
 public:
  Outwards(std::string_view text, bool backwards) : text_{text}, backwards_{backwards} {}

  [[nodiscard]] bool has(std::string_view letters, std::size_t away) const {
    return away < text_.size() && letters.find(letter(away)) != std::string_view::npos;
  }

  [[nodiscard]] bool spells(std::string_view group, std::size_t away) const {
    if (group.size() > text_.size() - std::min(away, text_.size())) return false;
    for (std::size_t i = 0; i < group.size(); ++i) {
      const char expected = backwards_ ? group[group.size() - 1 - i] : group[i];
      if (letter(away + i) != expected) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] char letter(std::size_t away) const {
    return backwards_ ? text_[text_.size() - 1 - away] : text_[away];
  }

  std::string_view text_;
  bool backwards_;
};

bool matches(std::string_view context, const Outwards& letters, std::size_t away);

/// Whether the symbol can take some letters so that the rest of the context matches beyond them.
bool matches(const LetterClass& symbol,
             std::string_view rest,
             const Outwards& letters,
             std::size_t away) {
  for (std::size_t taken = 0; taken <= symbol.most; ++taken) {
    if (taken > 0 && !letters.has(symbol.letters, away + taken - 1)) return false;
    if (taken >= symbol.least && matches(rest, letters, away + taken)) return true;
  }
  return false;
}

bool matches(std::string_view context, const Outwards& letters, std::size_t away) {
  if (context.empty()) return true;
  const char symbol = context.front();
  const auto rest = context.substr(1);
  const auto* const one = std::ranges::find(kClasses, symbol, &LetterClass::symbol);
  if (one != kClasses.end() && matches(*one, rest, letters, away)) return true;
  bool is_letter = one == kClasses.end();
  for (const auto& group : kGroups) {
    if (group.symbol != symbol) continue;
    is_letter = false;
    if (letters.spells(group.letters, away) && matches(rest, letters, away + group.letters.size()))
      return true;
  }
  return is_letter && letters.has(context.substr(0, 1), away) && matches(rest, letters, away + 1);
}

}  // namespace

bool is_of_context(char symbol) {
  return (symbol >= 'A' && symbol <= 'Z') ||
         std::string_view{" '#*:^$.+&@%"}.find(symbol) != std::string_view::npos;
}

std::string context_after(std::string_view context) {
  std::string ready;
  for (const char symbol : context) {
    if (symbol == '$') {
      ready += '^';
      ready += kEOrI;
    } else {
      ready += symbol;
    }
  }
  return ready;
}

std::string context_before(std::string_view context) {
  auto ready = context_after(context);
  std::ranges::reverse(ready);
  return ready;
}

bool stands_before(std::string_view ready_context, std::string_view text, std::size_t at) {
  return matches(ready_context, Outwards{text.substr(0, at), true}, 0);
}

bool stands_after(std::string_view ready_context, std::string_view text, std::size_t at) {
  return matches(ready_context, Outwards{text.substr(at), false}, 0);
}

}  // namespace bimodal
