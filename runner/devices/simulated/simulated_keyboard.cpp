#include "runner/devices/simulated/simulated_keyboard.hpp"

#include <chrono>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace bimodal::runner {
namespace {

constexpr std::string_view kSource = "simulated";

bool continues_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// The first character of `text`, which is not empty.
std::string_view first_character(std::string_view text) {
  std::size_t length = 1;
  while (length < text.size() && continues_character(text[length])) ++length;
  return text.substr(0, length);
}

}  // namespace

SimulatedKeyboard::SimulatedKeyboard(const Clock& clock) : SimulatedKeyboard{clock, Options{}} {}

SimulatedKeyboard::SimulatedKeyboard(const Clock& clock, const Options& options)
    : clock_{clock}, options_{options} {}

void SimulatedKeyboard::expect(std::string_view answer, Instant from) {
  planned_.clear();
  typed_ = 0;
  auto at = from + options_.first_key;
  if (const auto choice = options_.choices.find(answer); choice != options_.choices.end()) {
    plan(choice->second, at);
    if (options_.confirms_choice) plan({.key = Key::Enter}, at);
    return;
  }
  while (!answer.empty()) {
    const auto character = first_character(answer);
    plan({.key = Key::Text, .text = std::string{character}}, at);
    answer.remove_prefix(character.size());
  }
  plan({.key = Key::Enter}, at);
}

/// The next stroke comes after it.
void SimulatedKeyboard::plan(Keystroke stroke, Instant& at) {
  stroke.at = at;
  stroke.source = kSource;
  planned_.push_back(std::move(stroke));
  at += options_.between_keys;
}

std::vector<Keystroke> SimulatedKeyboard::poll() {
  const auto now = clock_.now();
  const auto first = typed_;
  while (typed_ < planned_.size() && planned_[typed_].at <= now) ++typed_;
  const auto begin = planned_.begin();
  return {std::next(begin, static_cast<std::ptrdiff_t>(first)),
          std::next(begin, static_cast<std::ptrdiff_t>(typed_))};
}

std::string SimulatedKeyboard::description() const {
  return fmt::format(
      "simulated: the first key {} ms after an answer is awaited, then every {} ms",
      std::chrono::duration_cast<std::chrono::milliseconds>(options_.first_key).count(),
      std::chrono::duration_cast<std::chrono::milliseconds>(options_.between_keys).count());
}

}  // namespace bimodal::runner
