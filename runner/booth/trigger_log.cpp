#include "runner/booth/trigger_log.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace bimodal::runner {

namespace {

using namespace std::chrono_literals;
using protocols::TriggerEvent;

/// Auditory zero is put on the lines so long before: more than some refreshes, and late enough for
/// the device to know when the sound began.
constexpr Duration kSoundAhead = 100ms;

Duration since_zero(Instant at) {
  return at.time_since_epoch();
}

}  // namespace

void TriggerLog::begin(int trial, std::string_view condition) {
  entries_.clear();
  entries_.reserve(2 + lines_.size() * protocols::kTriggerEvents.size());
  trial_ = trial;
  condition_ = condition;
  sound_told_ = false;
}

void TriggerLog::send(TriggerEvent event, Instant planned) {
  for (auto* const line : lines_) {
    std::optional<int> code;
    if (line->kind() == "serial") {
      if (!triggers_.serial) continue;
      code = triggers_.serial->codes[static_cast<std::size_t>(event)];
      if (!code) continue;
    }
    const auto event_name = protocols::name(event);
    Entry entry{.record = {.kind = std::string{line->kind()},
                           .event = std::string{event_name},
                           .code = code,
                           .planned = since_zero(planned),
                           .sent = std::nullopt,
                           .uncertainty = std::nullopt,
                           .source = "none"}};
    const bool posted = line->post({.event = event_name,
                                    .condition = condition_,
                                    .trial = trial_,
                                    .code = static_cast<std::uint8_t>(code.value_or(0)),
                                    .planned = planned});
    if (posted) entry.line = line;
    entries_.push_back(std::move(entry));
  }
}

void TriggerLog::zero_shown(const Presentation& shown,
                            const PreparedTrial& trial,
                            const CueSheet& cues) {
  const bool is_visual = trial.frames > 0;
  if (is_visual) send(TriggerEvent::VisualZero, shown.onset);
  if (!triggers_.photodiode) return;
  const auto event = is_visual ? TriggerEvent::VisualZero : TriggerEvent::AuditoryZero;
  const auto planned = is_visual ? cues.visual_zero() : cues.auditory_zero();
  entries_.push_back({.record = {.kind = "photodiode",
                                 .event = std::string{protocols::name(event)},
                                 .code = std::nullopt,
                                 .planned = since_zero(planned),
                                 .sent = since_zero(shown.onset),
                                 .uncertainty = std::nullopt,
                                 .source = std::string{name(shown.source)}}});
}

void TriggerLog::follow_sound(const PreparedTrial& trial,
                              const CueSheet& cues,
                              const Booth& booth) {
  if (sound_told_ || lines_.empty() || !trial.layout.has_sound) return;
  auto zero = cues.auditory_zero() + booth.reference.line_after;
  if (zero - booth.clock.now() > kSoundAhead) return;
  if (const auto playback = booth.audio.playback(); playback.onset) {
    zero = *playback.onset + booth.reference.sound_after + trial.layout.sound_lead;
  }
  send(TriggerEvent::AuditoryZero, zero);
  sound_told_ = true;
}

void TriggerLog::click_heard(const OnsetRecord& auditory) {
  if (!triggers_.click) return;
  entries_.push_back({.record = {.kind = "click",
                                 .event = std::string{protocols::name(TriggerEvent::AuditoryZero)},
                                 .code = std::nullopt,
                                 .planned = auditory.planned,
                                 .sent = auditory.reported,
                                 .uncertainty = std::nullopt,
                                 .source = auditory.source}});
}

void TriggerLog::take_reports() {
  for (auto* const line : lines_) {
    while (const auto report = line->next_report()) {
      if (report->signal.trial != trial_) continue;  // too late for its own trial
      const auto entry = std::ranges::find_if(entries_, [&](const Entry& sent) {
        return sent.line == line && sent.record.event == report->signal.event;
      });
      if (entry == entries_.end()) continue;
      entry->line = nullptr;
      if (!report->sent) continue;
      entry->record.sent = since_zero(*report->sent);
      entry->record.uncertainty = report->uncertainty;
      entry->record.source = "write_returned";
    }
  }
}

bool TriggerLog::settled() {
  take_reports();
  return std::ranges::all_of(entries_, [](const Entry& entry) { return entry.line == nullptr; });
}

void TriggerLog::finish(TrialRecord& record, Instant now) {
  take_reports();
  for (auto* const line : lines_) {
    std::string lost;
    for (const auto& entry : entries_) {
      if (entry.record.kind != line->kind() || entry.record.sent) continue;
      lost += (lost.empty() ? "" : ", ") + entry.record.event;
    }
    if (lost.empty()) continue;
    record.events.push_back({.at = since_zero(now),
                             .kind = "trigger_lost",
                             .detail = fmt::format("{}: not sent: {}", line->description(), lost)});
    record.flagged = true;
  }
  for (auto& entry : entries_) record.triggers.push_back(std::move(entry.record));
  entries_.clear();
}

}  // namespace bimodal::runner
