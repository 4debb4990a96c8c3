#include "protocols/reading/judge_triggers.hpp"

#include <algorithm>

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

}  // namespace

void judge_triggers(const Protocol& protocol, Findings& findings) {
  const auto& triggers = protocol.triggers;
  if (triggers.click) judge_click(protocol, *triggers.click, findings);
  if (triggers.photodiode) judge_photodiode(protocol, *triggers.photodiode, findings);
}

}  // namespace bimodal::protocols
