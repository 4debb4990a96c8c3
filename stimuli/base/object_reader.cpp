#include "stimuli/base/object_reader.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/base/json_lines.hpp"
#include "stimuli/base/json_text.hpp"
#include "stimuli/base/nearest.hpp"

namespace bimodal {

namespace {

using Json = nlohmann::json;

constexpr double kLargestExactWhole = 9007199254740991.0;  ///< 2^53 - 1 (RFC 7493)

std::string in_quotation_marks(std::span<const std::string_view> names) {
  std::string list;
  for (const auto name : names) list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
  return list;
}

bool is_control(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  return byte < 0x20U || byte == 0x7FU;
}

bool is_blank(char letter) {
  return letter == ' ' || letter == '\t' || letter == '\n';
}

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

bool has_forbidden_control(std::string_view text, bool one_line) {
  return std::ranges::any_of(text, [one_line](char letter) {
    return is_control(letter) && (one_line || (letter != '\n' && letter != '\t'));
  });
}

/// A key can stand in a message and a pointer as it is.
bool is_presentable(std::string_view key) {
  constexpr std::size_t kLongest = 80;
  return key.size() <= kLongest && std::ranges::none_of(key, is_control);
}

}  // namespace

std::string suggestion(std::string_view typed, std::span<const std::string_view> known) {
  std::string text;
  if (const auto near = nearest(typed, known)) text = fmt::format("did you mean \"{}\"? ", *near);
  return text + "Known here: " + in_quotation_marks(known);
}

ObjectReader::ObjectReader(const Json& value, std::string pointer, Findings& findings)
    : object_{value.is_object() ? &value : nullptr},
      pointer_{std::move(pointer)},
      findings_{&findings} {
  if (object_ == nullptr) {
    findings.error(pointer_,
                   fmt::format("{} is not an object", shown(value)),
                   "write keys and values in braces: { \"key\": value }");
  }
}

std::string ObjectReader::pointer_to(std::string_view key) const {
  return pointer_ + "/" + escape_pointer(key);
}

const Json* ObjectReader::find(std::string_view key) {
  if (std::ranges::find(known_, key) == known_.end()) known_.push_back(key);
  if (object_ == nullptr) return nullptr;
  const auto found = object_->find(key);
  return found == object_->end() ? nullptr : &*found;
}

bool ObjectReader::has(std::string_view key) {
  return find(key) != nullptr;
}

const Json* ObjectReader::require(std::string_view key, std::string_view meaning) {
  const auto* value = find(key);
  if (value == nullptr && object_ != nullptr) {
    findings_->error(pointer_,
                     fmt::format("the key \"{}\" is missing", key),
                     fmt::format("add \"{}\": {}", key, meaning));
  }
  return value;
}

void ObjectReader::wrong_type(const std::string& pointer,
                              const Json& value,
                              std::string_view wanted,
                              std::string remedy) {
  findings_->error(pointer, fmt::format("{} is not {}", shown(value), wanted), std::move(remedy));
}

std::optional<std::string> ObjectReader::text(std::string_view key, const TextRule& rule) {
  const auto* value = find(key);
  if (value == nullptr) return std::nullopt;
  return text_of(*value, pointer_to(key), rule);
}

std::optional<double> ObjectReader::judge_number(const Json& value,
                                                 const std::string& pointer,
                                                 const NumberRule& rule,
                                                 bool whole) {
  auto remedy = fmt::format("give {}", rule.meaning);
  if (!value.is_number()) {
    wrong_type(pointer, value, whole ? "a whole number" : "a number", std::move(remedy));
    return std::nullopt;
  }
  const auto number = value.get<double>();
  if (whole && number != std::floor(number)) {
    wrong_type(pointer, value, "a whole number", std::move(remedy));
    return std::nullopt;
  }
  if (!(number >= rule.low && number <= rule.high)) {
    findings_->error(pointer,
                     fmt::format("{} is outside {} to {}", shown(value), rule.low, rule.high),
                     std::move(remedy));
    return std::nullopt;
  }
  return number;
}

std::optional<double> ObjectReader::number(std::string_view key, const NumberRule& rule) {
  const auto* value = find(key);
  return value == nullptr ? std::nullopt : judge_number(*value, pointer_to(key), rule, false);
}

std::optional<std::int64_t> ObjectReader::whole(std::string_view key, const NumberRule& rule) {
  const auto* value = find(key);
  if (value == nullptr) return std::nullopt;
  const NumberRule exact{std::max(rule.low, -kLargestExactWhole),
                         std::min(rule.high, kLargestExactWhole),
                         rule.meaning};
  const auto number = judge_number(*value, pointer_to(key), exact, true);
  if (!number) return std::nullopt;
  return static_cast<std::int64_t>(*number);
}

std::optional<bool> ObjectReader::flag(std::string_view key) {
  const auto* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (!value->is_boolean()) {
    wrong_type(
        pointer_to(key), *value, "true or false", "write true or false, without quotation marks");
    return std::nullopt;
  }
  return value->get<bool>();
}

std::optional<Duration> ObjectReader::time(std::string_view key,
                                           Duration unit,
                                           const NumberRule& rule) {
  const auto amount = number(key, rule);
  if (!amount) return std::nullopt;
  return Duration{std::llround(*amount * static_cast<double>(unit.count()))};
}

std::optional<std::size_t> ObjectReader::choice(std::string_view key,
                                                std::span<const std::string_view> names) {
  const auto* value = find(key);
  if (value == nullptr) return std::nullopt;
  const auto typed = value->is_string() ? value->get<std::string>() : std::string{};
  const auto found = std::ranges::find(names, std::string_view{typed});
  if (!value->is_string() || found == names.end()) {
    findings_->error(
        pointer_to(key), fmt::format("{} is not known", shown(*value)), suggestion(typed, names));
    return std::nullopt;
  }
  return static_cast<std::size_t>(found - names.begin());
}

std::optional<ObjectReader> ObjectReader::object(std::string_view key) {
  const auto* value = find(key);
  if (value == nullptr) return std::nullopt;
  return ObjectReader{*value, pointer_to(key), *findings_};
}

std::vector<std::pair<const Json*, std::string>> ObjectReader::items(std::string_view key,
                                                                     std::size_t fewest,
                                                                     std::size_t most) {
  const auto* value = find(key);
  if (value == nullptr) return {};
  if (!value->is_array()) {
    wrong_type(pointer_to(key), *value, "an array", "write a list in brackets: [ ..., ... ]");
    return {};
  }
  if (value->size() < fewest || value->size() > most) {
    findings_->error(pointer_to(key),
                     fmt::format("{} items are outside {} to {}", value->size(), fewest, most),
                     value->size() < fewest ? "add one" : "remove some");
    return {};
  }
  std::vector<std::pair<const Json*, std::string>> items;
  items.reserve(value->size());
  for (const auto& item : *value) {
    items.emplace_back(&item, fmt::format("{}/{}", pointer_to(key), items.size()));
  }
  return items;
}

std::optional<std::string> ObjectReader::text_of(const Json& value,
                                                 const std::string& pointer,
                                                 const TextRule& rule) {
  const auto refuse = [&](std::string finding) {
    findings_->error(pointer, std::move(finding), fmt::format("give {}", rule.meaning));
    return std::nullopt;
  };
  if (!value.is_string()) return refuse(fmt::format("{} is not a text", shown(value)));
  const auto& text = value.get_ref<const std::string&>();
  const std::size_t length = characters(text);
  if (length == 0 && rule.shortest > 0) return refuse("the text is empty");
  if (length < rule.shortest || length > rule.longest) {
    return refuse(
        fmt::format("{} characters are outside {} to {}", length, rule.shortest, rule.longest));
  }
  if (has_forbidden_control(text, rule.one_line)) {
    return refuse(fmt::format("{} contains a control character{}",
                              shown(value),
                              rule.one_line ? " or a line break" : ""));
  }
  if (rule.one_line && length > 0 && (is_blank(text.front()) || is_blank(text.back()))) {
    return refuse(fmt::format("{} begins or ends with a blank", shown(value)));
  }
  return text;
}

std::optional<double> ObjectReader::number_of(const Json& value,
                                              const std::string& pointer,
                                              const NumberRule& rule) {
  return judge_number(value, pointer, rule, false);
}

void ObjectReader::refuse_unknown_keys() {
  if (object_ == nullptr) return;
  for (const auto& [key, value] : object_->items()) {
    if (std::ranges::find(known_, std::string_view{key}) != known_.end()) continue;
    findings_->error(is_presentable(key) ? pointer_to(key) : pointer_,
                     fmt::format("the key {} is not known", shown(Json(key))),
                     suggestion(key, known_));
  }
}

}  // namespace bimodal
