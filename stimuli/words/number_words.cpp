#include "stimuli/words/number_words.hpp"

#include <array>
#include <charconv>

namespace bimodal {

namespace {

constexpr std::array<std::string_view, 20> kOnes{
    "zero",     "one",     "two",     "three",     "four",     "five",    "six",
    "seven",    "eight",   "nine",    "ten",       "eleven",   "twelve",  "thirteen",
    "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"};
constexpr std::array<std::string_view, 10> kTens{
    "", "", "twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety"};
constexpr std::size_t kMostDigits = 6;

/// Below 1000; nothing for 0.
void say_hundreds(std::size_t number, std::vector<std::string_view>& words) {
  if (number >= 100) {
    words.push_back(kOnes.at(number / 100));
    words.emplace_back("hundred");
    number %= 100;
  }
  if (number >= 20) {
    words.push_back(kTens.at(number / 10));
    number %= 10;
  }
  if (number > 0) words.push_back(kOnes.at(number));
}

void say_digits(std::string_view digits, std::vector<std::string_view>& words) {
  for (const char digit : digits) words.push_back(kOnes.at(static_cast<std::size_t>(digit - '0')));
}

void say_whole(std::string_view digits, std::vector<std::string_view>& words) {
  if (digits.front() == '0' || digits.size() > kMostDigits) {
    say_digits(digits, words);
    return;
  }
  std::size_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (number >= 1000) {
    say_hundreds(number / 1000, words);
    words.emplace_back("thousand");
  }
  say_hundreds(number % 1000, words);
}

}  // namespace

std::vector<std::string_view> number_words(std::string_view number) {
  std::vector<std::string_view> words;
  const auto whole = number.substr(0, number.find('.'));
  say_whole(whole, words);
  if (whole.size() < number.size()) {
    words.emplace_back("point");
    say_digits(number.substr(whole.size() + 1), words);
  }
  return words;
}

}  // namespace bimodal
