#include "runner/monitor/session_picture.hpp"

#include <algorithm>
#include <functional>

#include "stimuli/base/json_text.hpp"

namespace bimodal::runner {

namespace {

using nlohmann::json;

const json* member(const json& object, std::string_view key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::string text_of(const json* value) {
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string{};
}

std::size_t count_of(const json* value) {
  return value != nullptr && value->is_number_unsigned() ? value->get<std::size_t>() : 0;
}

bool flag_of(const json* value) {
  return value != nullptr && value->is_boolean() && value->get<bool>();
}

}  // namespace

std::string SessionPicture::take(std::string_view line) {
  auto parsed = parse_json(line);
  auto* const object = std::get_if<json>(&parsed);
  if (object == nullptr) return {};
  auto kind = text_of(member(*object, "kind"));
  if (!kind.empty()) newest_[kind] = std::move(*object);
  return kind;
}

bool SessionPicture::knows(std::string_view kind) const {
  return newest_.contains(kind);
}

const json* SessionPicture::value(std::string_view kind, std::string_view key) const {
  const auto line = newest_.find(kind);
  return line == newest_.end() ? nullptr : member(line->second, key);
}

std::string SessionPicture::text(std::string_view kind, std::string_view key) const {
  return text_of(value(kind, key));
}

std::optional<std::int64_t> SessionPicture::number(std::string_view kind,
                                                   std::string_view key) const {
  const auto* const found = value(kind, key);
  if (found == nullptr || !found->is_number_integer()) return std::nullopt;
  constexpr std::int64_t kFarthest = 4'000'000'000'000'000'000;  // two of them can be added
  return std::clamp(found->get<std::int64_t>(), -kFarthest, kFarthest);
}

std::optional<double> SessionPicture::real(std::string_view kind, std::string_view key) const {
  const auto* const found = value(kind, key);
  if (found == nullptr || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

bool SessionPicture::flag(std::string_view kind, std::string_view key) const {
  return flag_of(value(kind, key));
}

std::vector<ConditionTally> SessionPicture::conditions() const {
  std::vector<ConditionTally> tallies;
  const auto* const listed = value("tally", "conditions");
  if (listed == nullptr || !listed->is_array()) return tallies;
  for (const auto& tally : *listed) {
    tallies.push_back({.condition = text_of(member(tally, "condition")),
                       .trials = count_of(member(tally, "trials")),
                       .judged = count_of(member(tally, "judged")),
                       .spelled_as_target = count_of(member(tally, "spelled_as_target"))});
  }
  return tallies;
}

std::vector<TalliedTrial> SessionPicture::latest_trials() const {
  std::vector<TalliedTrial> trials;
  const auto* const listed = value("tally", "latest");
  if (listed == nullptr || !listed->is_array()) return trials;
  for (const auto& trial : *listed) {
    TalliedTrial tallied{.trial = count_of(member(trial, "trial")),
                         .condition = text_of(member(trial, "condition")),
                         .word = text_of(member(trial, "word")),
                         .response = text_of(member(trial, "response")),
                         .spelled_as_target = std::nullopt,
                         .flagged = flag_of(member(trial, "flagged"))};
    const auto* const spelled = member(trial, "spelled_as_target");
    if (spelled != nullptr && spelled->is_boolean()) {
      tallied.spelled_as_target = spelled->get<bool>();
    }
    trials.push_back(std::move(tallied));
  }
  return trials;
}

std::string SessionPicture::last_events() const {
  std::string told;
  const auto* const listed = value("result", "events");
  if (listed == nullptr || !listed->is_array()) return told;
  for (const auto& event : *listed) {
    told += told.empty() ? "" : "; ";
    told += text_of(member(event, "kind")) + ": " + text_of(member(event, "detail"));
  }
  return told;
}

}  // namespace bimodal::runner
