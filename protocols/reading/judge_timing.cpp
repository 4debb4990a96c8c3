#include "protocols/reading/judge_timing.hpp"

#include <algorithm>

namespace bimodal::protocols {

void judge_timing(const Protocol& protocol, Findings& findings) {
  if (findings.faulty("/timing") || findings.faulty("/conditions")) return;
  const bool seen = std::ranges::any_of(protocol.conditions, [](const Condition& condition) {
    return condition.visual_talker.has_value();
  });
  if (protocol.timing.visual_line == VisualLine::Mouth && !seen) {
    findings.warning("/timing/visual_line",
                     "nobody is seen in any condition, so there is no mouth",
                     "remove it");
  }
}

}  // namespace bimodal::protocols
