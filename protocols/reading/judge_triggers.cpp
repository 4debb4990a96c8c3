#include "protocols/reading/judge_triggers.hpp"

#include <algorithm>
#include <span>

#include <fmt/format.h>

namespace bimodal::protocols {

namespace {

void judge_click(const Protocol& protocol, const Click& click, Findings& findings) {
  if (findings.faulty("/triggers/click") || findings.faulty("/sound/channels")) return;
  const auto& channels = protocol.sound.channels;
  const bool is_heard = channels.empty()
                            ? click.channel <= 2
                            : std::ranges::find(channels, click.channel) != channels.end();
  if (is_heard) {
    findings.error("/triggers/click/channel",
                   fmt::format("the stimulus is played on channel {} too{}, where the click would "
                               "be heard",
                               click.channel,
                               channels.empty() ? " (both ears are channels 1 and 2)" : ""),
                   "choose another channel, or set /sound/channels, e.g. to [1]");
  }
  const bool any_sound = std::ranges::any_of(protocol.conditions, [](const Condition& condition) {
    return condition.auditory_talker.has_value();
  });
  if (!any_sound && !findings.faulty("/conditions")) {
    findings.warning("/triggers/click",
                     "nothing is heard in any condition, so there is never a click",
                     "remove it, or use a photodiode, a serial port or a socket");
  }
}

void judge_photodiode(const Protocol& protocol, const Photodiode& patch, Findings& findings) {
  if (findings.faulty("/triggers/photodiode") || findings.faulty("/window")) return;
  const auto& window = protocol.window;
  if (patch.size > window.width || patch.size > window.height) {
    findings.error("/triggers/photodiode/size_px",
                   fmt::format("the patch, {} pixels both ways, is larger than the window, {} x {}",
                               patch.size,
                               window.width,
                               window.height),
                   "make it smaller: 60 pixels are enough for most sensors");
    return;
  }
  const auto box = patch_box(patch, window.width, window.height);
  if (box.left >= 0 && box.top >= 0 && box.left + box.width <= window.width &&
      box.top + box.height <= window.height) {
    return;
  }
  findings.error("/triggers/photodiode/centre",
                 "the patch reaches beyond the window",
                 "move its middle inwards, or choose a \"corner\"");
}

/// Who records the bytes must be able to tell the events apart.
void judge_codes(const SerialTriggers& serial, Findings& findings) {
  if (findings.faulty("/triggers/serial")) return;
  const auto& codes = serial.codes;
  for (std::size_t later = 1; later < codes.size(); ++later) {
    const auto before = std::span{codes}.first(later);
    const auto earlier = std::ranges::find(before, codes[later]);
    if (!codes[later] || earlier == before.end()) continue;
    findings.warning(
        fmt::format("/triggers/serial/codes/{}", kTriggerEvents[later]),
        fmt::format("{} has the code {} too: what is recorded cannot tell the two apart",
                    kTriggerEvents[static_cast<std::size_t>(earlier - before.begin())],
                    *codes[later]),
        "give every event a code of its own");
  }
}

}  // namespace

void judge_triggers(const Protocol& protocol, Findings& findings) {
  const auto& triggers = protocol.triggers;
  if (triggers.click) judge_click(protocol, *triggers.click, findings);
  if (triggers.photodiode) judge_photodiode(protocol, *triggers.photodiode, findings);
  if (triggers.serial) judge_codes(*triggers.serial, findings);
}

}  // namespace bimodal::protocols
