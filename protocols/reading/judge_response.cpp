#include "protocols/reading/judge_response.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "stimuli/base/json_text.hpp"
#include "stimuli/base/lower_case.hpp"

namespace bimodal::protocols {

namespace {

using namespace std::chrono_literals;

constexpr Duration kShortTimeLimit = 2s;

void judge_time_limit(const Response& response, Findings& findings) {
  if (response.kind == ResponseKind::Choice || findings.faulty("/response/time_limit_s")) return;
  if (!response.time_limit || *response.time_limit >= kShortTimeLimit) return;
  findings.warning("/response/time_limit_s",
                   "few people can type a word in less than 2 s",
                   "allow more time, or write null for no limit");
}

void judge_length(const Response& response, const std::vector<Word>& words, Findings& findings) {
  if (words.empty() || response.kind == ResponseKind::Choice) return;
  if (findings.faulty("/response/longest")) return;
  const auto longest =
      std::ranges::max_element(words, {}, [](const Word& word) { return word.spelling.size(); });
  if (static_cast<std::size_t>(response.longest) >= longest->spelling.size()) return;
  findings.error(
      "/response/longest",
      fmt::format(
          "{} characters are too few to type {}", response.longest, shown(longest->spelling)),
      "raise it");
}

/// Every condition must have what reaction time counts from.
void judge_reference(const Protocol& protocol, Findings& findings) {
  const auto from = protocol.response.rt_from;
  if (from == RtFrom::End || findings.faulty("/conditions")) return;
  if (findings.faulty("/response/rt_from")) return;
  const bool from_sound = from == RtFrom::SoundOnset;
  for (const auto& condition : protocol.conditions) {
    const auto& talker = from_sound ? condition.auditory_talker : condition.visual_talker;
    if (talker) continue;
    findings.error(
        "/response/rt_from",
        fmt::format("the condition {} has no {}, from whose onset reaction time could count",
                    shown(condition.name),
                    from_sound ? "sound" : "picture"),
        "count from \"end\", or from what every condition has");
  }
}

/// Labels that only capitals tell apart look alike to whoever reads the data.
void judge_labels(const Response& response, Findings& findings) {
  if (response.kind == ResponseKind::Typed || findings.faulty("/response/options")) return;
  std::map<std::string, std::string> seen;
  for (std::size_t i = 0; i < response.options.size(); ++i) {
    const auto& label = response.options[i].label;
    const auto [other, is_new] = seen.emplace(lower_case(label), label);
    if (is_new || other->second == label) continue;
    findings.warning(
        fmt::format("/response/options/{}/label", i),
        fmt::format("only capitals tell {} from {}", shown(label), shown(other->second)),
        "choose labels that differ in their letters");
  }
}

/// A choice among words of the list leaves those that are no label never right. Labels may also be
/// none of the words: sounds, say, or how sure one is.
void judge_targets(const Response& response, const std::vector<Word>& words, Findings& findings) {
  if (response.kind == ResponseKind::Typed || findings.faulty("/response/options")) return;
  const auto is_label = [&](const Word& word) {
    return std::ranges::any_of(response.options, [&](const Option& option) {
      return lower_case(option.label) == lower_case(word.spelling);
    });
  };
  const auto labelled = static_cast<std::size_t>(std::ranges::count_if(words, is_label));
  if (labelled == 0 || labelled == words.size()) return;
  const auto other = std::ranges::find_if_not(words, is_label);
  findings.warning("/response/options",
                   fmt::format("{} of {} words, {} the first, are no option's label: no answer to "
                               "them is right",
                               words.size() - labelled,
                               words.size(),
                               shown(other->spelling)),
                   "add options, or choose a list of those words");
}

}  // namespace

void judge_response(const Protocol& protocol, const std::vector<Word>& words, Findings& findings) {
  if (findings.faulty("/response/kind")) return;
  judge_time_limit(protocol.response, findings);
  judge_length(protocol.response, words, findings);
  judge_labels(protocol.response, findings);
  judge_targets(protocol.response, words, findings);
  judge_reference(protocol, findings);
}

}  // namespace bimodal::protocols
