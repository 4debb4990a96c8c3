#include "protocols/reading/read_response.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "stimuli/base/json_text.hpp"
#include "stimuli/base/lower_case.hpp"

namespace bimodal::protocols {

namespace {

using namespace std::chrono_literals;

constexpr std::array<std::string_view, 2> kKinds{"typed", "choice"};
constexpr std::array<std::string_view, 2> kFrom{"end", "onset"};
constexpr std::array<std::string_view, 3> kRtFrom{
    name(RtFrom::End), name(RtFrom::SoundOnset), name(RtFrom::VisualOnset)};

/// Keys of the two kinds of answers, which the other kind does not have.
constexpr std::array<std::string_view, 1> kOfTyped{"longest"};
constexpr std::array<std::string_view, 4> kOfChoice{"options", "pointer", "confirm", "from"};

constexpr std::size_t kFewestOptions = 2;
constexpr std::size_t kMostOptions = 40;
constexpr std::string_view kExampleOptions = R"([{"label": "ba"}, {"label": "wa"}])";

/// Keys where no option names one: as many as there are digits.
constexpr std::array<std::string_view, 9> kDefaultKeys{"1", "2", "3", "4", "5", "6", "7", "8", "9"};

void read_limit(ObjectReader& reader, Response& response) {
  const auto* const limit = reader.find("time_limit_s");
  if (limit == nullptr || limit->is_null()) return;
  response.time_limit = reader.time(
      "time_limit_s", 1s, {0.1, 600, "a time in seconds, e.g. 10, or null for no limit"});
}

Option read_option(const nlohmann::json& value, const std::string& pointer, Findings& findings) {
  Option option;
  ObjectReader reader{value, pointer, findings};
  constexpr std::string_view kLabel = "what is seen and stored, e.g. \"ba\"";
  reader.require("label", kLabel);
  if (auto label = reader.text("label", {.shortest = 1, .longest = 40, .meaning = kLabel})) {
    option.label = std::move(*label);
  }
  if (auto key = reader.text(
          "key",
          {.shortest = 1, .longest = 1, .meaning = "the one character of a key, e.g. \"b\""})) {
    option.key = std::move(*key);
  }
  const auto button =
      reader.whole("button", {1, 64, "the number of a button of a button box, from 1"});
  if (button) option.button = static_cast<int>(*button);
  reader.refuse_unknown_keys();
  return option;
}

/// An error at each option whose part (a label, a key, a button) an earlier one has too.
template <typename PartOf>
void refuse_doubles(const std::vector<Option>& options,
                    std::string_view key,
                    PartOf part_of,
                    Findings& findings) {
  for (std::size_t i = 0; i < options.size(); ++i) {
    const auto part = part_of(options[i]);
    if (part.empty()) continue;
    const auto first = std::ranges::find(options, part, part_of);
    const auto earlier = static_cast<std::size_t>(first - options.begin());
    if (earlier == i) continue;
    findings.error(fmt::format("/response/options/{}/{}", i, key),
                   fmt::format("option {} has the same {}", earlier + 1, key),
                   fmt::format("give every option a {} of its own", key));
  }
}

void judge_options(const std::vector<Option>& options, Findings& findings) {
  const auto label = [](const Option& option) { return option.label; };
  refuse_doubles(options, "label", label, findings);
  const auto key = [](const Option& option) { return lower_case(option.key); };
  refuse_doubles(options, "key", key, findings);
  const auto button = [](const Option& option) {
    return option.button == 0 ? std::string{} : std::to_string(option.button);
  };
  refuse_doubles(options, "button", button, findings);
}

void number_keys(std::vector<Option>& options) {
  if (std::ranges::any_of(options, [](const Option& option) { return !option.key.empty(); })) {
    return;
  }
  for (std::size_t i = 0; i < std::min(options.size(), kDefaultKeys.size()); ++i) {
    options[i].key = kDefaultKeys[i];
  }
}

/// Every option must be within reach.
void judge_reach(const Response& response, Findings& findings) {
  for (std::size_t i = 0; i < response.options.size(); ++i) {
    const auto& option = response.options[i];
    if (response.pointer || !option.key.empty() || option.button != 0) continue;
    findings.error(fmt::format("/response/options/{}", i),
                   fmt::format("nothing chooses {}: it has neither key nor button, and there is "
                               "no pointer",
                               shown(option.label)),
                   "give it a \"key\" (only the first nine have one by themselves, if none is "
                   "given), or write \"pointer\": true");
  }
}

void read_options(ObjectReader& reader, Response& response, Findings& findings) {
  reader.require("options", kExampleOptions);
  for (const auto& [value, pointer] : reader.items("options", kFewestOptions, kMostOptions)) {
    response.options.push_back(read_option(*value, pointer, findings));
  }
  response.pointer = reader.flag("pointer").value_or(false);
  if (findings.faulty("/response/options")) return;
  judge_options(response.options, findings);
  number_keys(response.options);
  if (!findings.faulty("/response/pointer")) judge_reach(response, findings);
}

void read_choice(ObjectReader& reader, Response& response, Findings& findings) {
  read_options(reader, response, findings);
  response.confirm = reader.flag("confirm").value_or(false);
  if (const auto from = reader.choice("from", kFrom)) {
    response.from = static_cast<AnswersFrom>(*from);
  }
}

void read_typed(ObjectReader& reader, Response& response) {
  const auto longest =
      reader.whole("longest", {1, 200, "the most characters of an answer, e.g. 40"});
  if (longest) response.longest = static_cast<int>(*longest);
}

template <std::size_t kCount>
void refuse_keys(ObjectReader& reader,
                 const std::array<std::string_view, kCount>& keys,
                 std::string_view kind,
                 Findings& findings) {
  const bool unclear = findings.faulty(reader.pointer_to("kind"));  // this one may be meant
  for (const auto key : keys) {
    if (!reader.has(key) || unclear) continue;
    findings.error(reader.pointer_to(key),
                   fmt::format("only answers of kind \"{}\" have it", kind),
                   fmt::format("remove it, or write \"kind\": \"{}\"", kind));
  }
}

}  // namespace

Response read_response(ObjectReader& parent, Findings& findings) {
  Response response;
  auto reader = parent.object("response");
  if (!reader) return response;
  if (const auto kind = reader->choice("kind", kKinds)) {
    response.kind = static_cast<ResponseKind>(*kind);
  }
  if (auto prompt = reader->text("prompt", {.longest = 200, .meaning = "a question of one line"})) {
    response.prompt = std::move(*prompt);
  }
  read_limit(*reader, response);
  if (const auto from = reader->choice("rt_from", kRtFrom)) {
    response.rt_from = static_cast<RtFrom>(*from);
  }
  if (response.kind == ResponseKind::Choice) {
    read_choice(*reader, response, findings);
    refuse_keys(*reader, kOfTyped, kKinds[0], findings);
  } else {
    read_typed(*reader, response);
    refuse_keys(*reader, kOfChoice, kKinds[1], findings);
  }
  reader->refuse_unknown_keys();
  return response;
}

}  // namespace bimodal::protocols
