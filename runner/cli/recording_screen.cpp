#include "runner/cli/recording_screen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "stimuli/base/counted.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal::runner {

namespace {

using Phase = RecordingMachine::Phase;
using Paint = std::array<float, 3>;

constexpr Paint kRed{0.84F, 0.10F, 0.10F};
constexpr Paint kGreen{0.13F, 0.55F, 0.25F};
constexpr Paint kOrange{0.85F, 0.50F, 0.05F};
constexpr Paint kTrack{0.80F, 0.80F, 0.78F};
constexpr Paint kWaiting{0.80F, 0.80F, 0.78F};

constexpr double kWordSize = 0.16;  ///< of the window's height
constexpr double kWordPlace = 0.42;
constexpr double kDotPlace = 0.20;
constexpr double kDotSize = 0.07;
constexpr double kAdvicePlace = 0.64;
constexpr double kMeterPlace = 0.735;
constexpr double kMeterWidth = 0.4;  ///< of the window's width
constexpr double kMeterHeight = 0.014;
constexpr double kMeterLowest = -60.0;  ///< dB FS at its left end; full scale is its right end
constexpr std::size_t kLettersOfFullSize = 12;

void add(Screen& screen, std::string text, double centre_y, double size) {
  screen.captions.push_back({.text = std::move(text), .centre_y = centre_y, .size = size});
}

void add_dot(Screen& screen, const Paint& paint) {
  screen.marks.push_back({.shape = Mark::Shape::Disc,
                          .centre_x = 0.5,
                          .centre_y = kDotPlace,
                          .width = 0.0,
                          .height = kDotSize,
                          .colour = paint});
}

/// A box of the meter from one level to another.
void add_level(Screen& screen, double from, double to, double height, const Paint& paint) {
  const auto part = [](double level) {
    return (std::clamp(level, kMeterLowest, 0.0) - kMeterLowest) / -kMeterLowest;
  };
  const double left = 0.5 - kMeterWidth / 2.0 + kMeterWidth * part(from);
  const double width = kMeterWidth * (part(to) - part(from));
  screen.marks.push_back({.shape = Mark::Shape::Box,
                          .centre_x = left + width / 2.0,
                          .centre_y = kMeterPlace,
                          .width = width,
                          .height = height,
                          .colour = paint});
}

bool has(const ShownTake& take, TakeFault fault) {
  return std::ranges::find(take.faults, fault) != take.faults.end();
}

/// The peak of the last take between too quiet and too loud.
void add_meter(Screen& screen, const ShownTake& take, std::string_view whose) {
  const auto& measures = take.measures;
  const double peak = measures.peak.count();
  const bool is_bad = has(take, TakeFault::Clipped);
  const bool is_doubtful = has(take, TakeFault::Quiet);
  add_level(screen, kMeterLowest, 0.0, kMeterHeight, kTrack);
  add_level(screen,
            kMeterLowest,
            peak,
            kMeterHeight,
            is_bad        ? kRed
            : is_doubtful ? kOrange
                          : kGreen);
  constexpr double kTick = 0.15;  // dB
  const double lowest = TakeRules{}.lowest_peak.count();
  add_level(screen, lowest - kTick, lowest + kTick, 2.0 * kMeterHeight, {0.3F, 0.3F, 0.3F});
  auto text = fmt::format("{}peak {:.0f} dB", whose, peak);
  if (measures.speech) {
    text = fmt::format("{}speech {:.0f} dB, peak {:.0f} dB, {:.0f} dB above the room",
                       whose,
                       measures.level.count(),
                       peak,
                       measures.snr.count());
  }
  if (measures.clipped > 0) text += ", " + counted(measures.clipped, "clipped sample");
  add(screen, std::move(text), kMeterPlace + 0.04, 0.024);
}

std::size_t letters_of(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); ++count) {
    at += std::max<std::size_t>(1, utf8_length(text, at));
  }
  return count;
}

void add_word(Screen& screen, const std::string& word) {
  const auto letters = std::max(letters_of(word), kLettersOfFullSize);
  add(screen,
      word,
      kWordPlace,
      kWordSize * static_cast<double>(kLettersOfFullSize) / static_cast<double>(letters));
}

void add_page(Screen& screen, std::string text, std::string keys) {
  add(screen, std::move(text), 0.42, 0.04);
  add(screen, std::move(keys), 0.90, 0.025);
}

std::string welcome(const RecordingMachine& machine) {
  const auto left = machine.slots().size() - machine.done();
  const auto begun = machine.done() == 0
                         ? counted(left, "word")
                         : fmt::format("{} recorded, {} to go", machine.done(), left);
  return begun +
         "\n\nYou will see one word at a time. When the dot is red, say the word.\n"
         "Then wait until the dot has gone.\n\n"
         "First the room is recorded: please be quiet for two seconds.";
}

std::string farewell(const RecordingMachine& machine) {
  const auto left = machine.slots().size() - machine.done();
  if (left == 0) return "All words are recorded.\n\nThank you!";
  return fmt::format(
      "This is the end of the list. {} passed over;\nstart again to record {}.\n\nThank you!",
      left == 1 ? "One word was" : fmt::format("{} words were", left),
      left == 1 ? "it" : "them");
}

std::string_view help_of(const RecordingMachine& machine) {
  switch (machine.phase()) {
    case Phase::Ready:
      if (machine.slots()[machine.slot()].done) {
        return "Recorded already.   Space: record it anew   S: go on   Left: the word before   "
               "R: the old take is no good";
      }
      return machine.awaits_key()
                 ? "Space: record   R: the last one again   Left: the word before   S: pass over   "
                   "Escape: stop"
                 : "R: the last one again   S: pass over   Escape: stop";
    case Phase::Recording:
      return "R: begin anew   Escape: stop";
    case Phase::Praise:
      return "R: say it again";
    case Phase::Doubt:
      if (!machine.awaits_key()) return "Once more, please ...";
      return machine.can_keep()
                 ? "Space: once more   K: keep it all the same   S: pass over   Escape: stop"
                 : "Space: once more   S: pass over   Escape: stop";
    default:
      return "";
  }
}

/// The phases in which a word is on the screen.
void show_word(Screen& screen,
               const RecordingMachine& machine,
               const std::optional<ShownTake>& last) {
  const auto phase = machine.phase();
  add(screen, fmt::format("{} of {}", machine.slot() + 1, machine.slots().size()), 0.06, 0.025);
  add_word(screen, machine.slots()[machine.slot()].text);
  if (phase == Phase::Arming) add_dot(screen, kWaiting);
  if (phase == Phase::Recording) add_dot(screen, kRed);
  const bool is_judged = phase == Phase::Praise || phase == Phase::Doubt;
  if (phase == Phase::Praise) add(screen, "Good.", kAdvicePlace, 0.04);
  if (phase == Phase::Doubt && last && !last->faults.empty()) {
    add(screen, std::string{advice(last->faults.front())}, kAdvicePlace, 0.04);
  }
  if (last && is_judged) add_meter(screen, *last, "");
  if (last && phase == Phase::Ready) add_meter(screen, *last, "last take: ");
  add(screen, std::string{help_of(machine)}, 0.90, 0.025);
}

}  // namespace

Screen recording_screen(const RecordingMachine& machine, const std::optional<ShownTake>& last) {
  Screen screen;
  screen.progress =
      static_cast<double>(machine.done()) / static_cast<double>(machine.slots().size());
  switch (machine.phase()) {
    case Phase::Welcome:
      add_page(screen, welcome(machine), "Space: begin   Escape: stop");
      break;
    case Phase::Room:
    case Phase::RoomJudging:
      add_dot(screen, kWaiting);  // not red: that would ask for a word
      add_page(screen, "Please be quiet for a moment ...", "");
      break;
    case Phase::RoomDoubt:
      add_page(screen,
               "It was not quiet.\n\nWait until the room is still, and listen to it once more.",
               "Space: listen again   K: go on all the same   Escape: stop");
      break;
    case Phase::Confirming:
      add_page(
          screen,
          "Stop the recording here?\n\nWhat has been recorded is kept;\nstarted again, it goes "
          "on with the next word.",
          "Escape: stop   Space: go on");
      break;
    case Phase::Complete:
    case Phase::Ended:
      add_page(screen, farewell(machine), "Space: end");
      break;
    default:
      show_word(screen, machine, last);
  }
  return screen;
}

}  // namespace bimodal::runner
