#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/ranges.h>

#include "protocols/model/talker.hpp"
#include "runner/cli/media_check.hpp"
#include "runner/cli/protocol_file.hpp"
#include "runner/cli/session_face.hpp"
#include "runner/cli/session_level.hpp"
#include "runner/cli/session_triggers.hpp"
#include "runner/cli/sound_check.hpp"
#include "runner/cli/verbs.hpp"
#include "runner/preparation/films_ahead.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

using protocols::Assignment;
using protocols::ReadProtocol;

/// From the stimulus's end to Enter, on average; a guess, used only for the estimate of duration.
constexpr double kAnswerSeconds = 4.0;
constexpr double kWordSeconds = 1.0;

double seconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

int sessions_of(const protocols::Protocol& protocol) {
  return protocol.assignment == Assignment::Once ? 1 : static_cast<int>(protocol.conditions.size());
}

/// "3 times as fast, reversed, gated", as far as it applies.
std::string manner_text(const protocols::Manner& manner) {
  std::vector<std::string> parts;
  if (manner.rate != 1.0) parts.push_back(fmt::format("{:g} times as fast", manner.rate));
  if (manner.reversed) parts.emplace_back("reversed");
  if (manner.gate) parts.emplace_back("gated");
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// How the picture is changed, as far as it is.
std::string look_text(const protocols::Look& look) {
  std::vector<std::string> parts;
  if (!look.like.empty()) parts.push_back(fmt::format("like {}", look.like));
  if (look.frame_rate) parts.push_back(fmt::format("{:g} frames/s", look.frame_rate->count()));
  if (look.lines) parts.push_back(fmt::format("{} lines", *look.lines));
  if (look.height) parts.push_back(fmt::format("{} pixels high", *look.height));
  if (look.blur_px > 0.0) parts.push_back(fmt::format("blurred by {:g} pixels", look.blur_px));
  if (look.background) parts.push_back(fmt::format("background #{:06x}", *look.background));
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// How the face articulates, as far as it is not by default.
std::string articulating_text(const protocols::Articulating& articulating) {
  std::vector<std::string> parts;
  const protocols::Articulating usual;
  if (articulating.account != usual.account) parts.emplace_back(name(articulating.account));
  const auto inventory = std::filesystem::path{articulating.segments}.stem().string();
  if (inventory != usual.segments) parts.push_back("segments of " + inventory);
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// What is different about the face, as far as it is.
std::string face_text(const protocols::Face& face) {
  std::vector<std::string> parts;
  const protocols::Face usual;
  if (face.view != usual.view) parts.push_back(fmt::format("from {}", face.view));
  if (!face.material.empty()) parts.push_back(fmt::format("material {}", face.material));
  if (!face.show.empty()) parts.push_back(fmt::format("only {}", fmt::join(face.show, ", ")));
  if (!face.hide.empty()) parts.push_back(fmt::format("without {}", fmt::join(face.hide, ", ")));
  if (face.transparency > 0.0) {
    parts.push_back(fmt::format("skin {:g} transparent", face.transparency));
  }
  if (face.points != usual.points) parts.push_back(fmt::format("points of light: {}", face.points));
  for (const auto* amounts : {&face.expression, &face.controls}) {
    for (const auto& [name, amount] : *amounts) {
      parts.push_back(fmt::format("{} {:g}", name, amount));
    }
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

void print_details(const protocols::Condition& condition) {
  const auto print_line = [](std::string_view what, std::string_view text) {
    if (!text.empty()) fmt::print("               {:<14} {} {}\n", "", what, text);
  };
  print_line("presented", manner_text(condition.manner));
  print_line("looks", look_text(condition.look));
  print_line("articulates", articulating_text(condition.articulating));
  if (condition.visual_talker && !protocols::is_corpus(*condition.visual_talker)) {
    print_line("face", face_text(condition.face));
  }
  if (condition.av_offset) {
    print_line("sound after picture",
               fmt::format("{:+g} ms", 1000.0 * seconds(*condition.av_offset)));
  }
}

void print_words(std::string_view what, std::vector<std::string> words) {
  constexpr std::size_t kShown = 6;
  const auto count = words.size();
  if (count == 0) return;
  if (count > kShown) words.resize(kShown);
  fmt::print("  {:<12} {}: {}{}\n",
             what,
             counted(count, "word"),
             fmt::join(words, ", "),
             count > kShown ? ", ..." : "");
}

void print_unusual_words(const ReadProtocol& read) {
  std::vector<std::string> dubbed;
  std::vector<std::string> ambiguous;
  for (const auto& word : read.words.words) {
    if (word.seen) dubbed.push_back(shown_name(word));
    const auto& shown = word.seen ? word.seen->articulation : word.articulation;
    if (!shown.empty()) {
      ambiguous.push_back(fmt::format("{} ({})", shown_name(word), spell(shown)));
    }
  }
  print_words("dubbed", std::move(dubbed));
  print_words("ambiguous", std::move(ambiguous));
}

void print_summary(const ReadProtocol& read, std::size_t trials) {
  const auto& protocol = read.protocol;
  const auto& times = protocol.intervals;
  const double trial_s = seconds(times.fixation + times.lead + times.trail + times.pause) +
                         kWordSeconds + kAnswerSeconds;
  fmt::print("{}\n", protocol.title);
  fmt::print("  words        {} of list \"{}\", {} for practice\n",
             read.words.words.size(),
             read.words.name,
             read.practice.size());
  for (const auto& condition : protocol.conditions) {
    fmt::print("  condition    {:<14} hears {:<14} sees {:<14} {}\n",
               condition.name,
               condition.auditory_talker.value_or("nothing"),
               condition.visual_talker.value_or("no face"),
               condition.snr ? fmt::format("{:g} dB S/N in {:g}-{:g} Hz",
                                           condition.snr->count(),
                                           protocol.sound.noise.band_low.count(),
                                           protocol.sound.noise.band_high.count())
                             : std::string{});
    print_details(condition);
  }
  print_unusual_words(read);
  if (const auto kinds = trigger_kinds(protocol.triggers); !kinds.empty()) {
    fmt::print("  triggers     {}\n", kinds);
  }
  fmt::print("  assignment   {}\n",
             protocol.assignment == Assignment::Once
                 ? "once: each word in one condition per participant"
                 : fmt::format("every-condition: over {} sessions", sessions_of(protocol)));
  const auto minutes = std::max(1L, std::lround(static_cast<double>(trials) * trial_s / 60.0));
  fmt::print("  a session    {}, about {}\n",
             counted(trials, "trial"),
             counted(static_cast<std::size_t>(minutes), "minute"));
}

/// Of a planned trial: whether it shows the synthetic face.
auto shows_face(const protocols::Protocol& protocol) {
  return [&protocol](const protocols::PlannedTrial& trial) {
    const auto& talker = protocol.conditions.at(trial.condition).visual_talker;
    return talker && !protocols::is_corpus(*talker);
  };
}

/// Full quality, where it is asked for, is measured: an experimenter must know how long it takes.
std::string drawing_text(const ReadProtocol& read,
                         const std::vector<protocols::PlannedTrial>& plan) {
  const auto wanted = read.protocol.window.face_quality;
  if (wanted == protocols::FaceQuality::Fast) {
    return describe(choose_quality(wanted, std::nullopt));
  }
  if (wanted == protocols::FaceQuality::Auto) {
    return "the face is drawn in full quality if that keeps ahead of the session, else in fast: "
           "`run` measures it";
  }
  constexpr Hertz kUsualRate{60};
  const auto face = examine_face(read, plan, true);
  const auto quality = quality_of(*face, read.protocol, kUsualRate);
  auto text = describe(quality);
  if (!draws_too_slowly(quality)) return text;
  const auto films = std::ranges::count_if(plan, shows_face(read.protocol));
  return fmt::format("{}; `run` draws the films of a session before its first trial, {}",
                     text,
                     about_minutes(film_time(*quality.pace) * films));
}

void print_face(const ReadProtocol& read, const std::vector<protocols::PlannedTrial>& plan) {
  if (std::ranges::none_of(plan, shows_face(read.protocol))) return;
  try {
    fmt::print("  drawing      {}\n", drawing_text(read, plan));
  } catch (const Error& error) {  // checked on a machine that will not run it, perhaps
    fmt::print("  drawing      the face cannot be drawn here: {}\n", error.what());
  }
}

std::vector<Diagnostic> check_stimuli(ReadProtocol& read,
                                      const std::string& file,
                                      SessionLevel& level) {
  auto found = check_media(read, file);
  if (has_errors(found)) return found;
  const auto equipment = check_trigger_equipment(read, file);
  found.insert(found.end(), equipment.begin(), equipment.end());
  level = checked_level(read, file, found);
  Repertoire repertoire{read.protocol.sound.rate, read.corpora};
  TrialPreparer preparer{read.protocol, repertoire, nullptr, Hertz{60}};
  const auto sounds = check_sounds(read, every_stimulus(read), preparer, file);
  found.insert(found.end(), sounds.begin(), sounds.end());
  return found;
}

ExitCode check(const ProtocolChoice& choice) {
  auto read = load_protocol(choice);
  if (!read) return ExitCode::InvalidInput;
  SessionLevel level;
  const auto found = check_stimuli(*read, find_protocol(choice.named).string(), level);
  print(found);
  if (has_errors(found)) {
    fmt::print(stderr, "bimodal: the protocol cannot be used: its stimuli cannot be presented\n");
    return ExitCode::InvalidInput;
  }
  const auto plan = protocols::make_plan(read->protocol, read->words, read->practice, {});
  print_summary(*read, plan.size());
  print_face(*read, plan);
  if (!level.text.empty()) fmt::print("  level        {}\n", level.text);
  const auto warnings = read->diagnostics.size() + found.size();
  if (warnings == 0) {
    fmt::print("no mistakes found\n");
  } else {
    fmt::print("usable, with {}\n", counted(warnings, "warning"));
  }
  return warnings == 0 ? ExitCode::Done : ExitCode::Findings;
}

}  // namespace

void add_check(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "check",
      "Reads a protocol whole, with every file that it needs, and prints all mistakes at once.\n"
      "Makes every word in every condition in which it is heard, so that none is found to clip "
      "later.\n"
      "Of corpora it verifies every recording that is needed: that it is the one of the manifest, "
      "and\nhas the sound and picture that are to be presented.\n"
      "Exit code: 0 clean, 1 warnings, 3 errors.\n\n"
      "Examples:\n"
      "  bimodal check words414 --corpus natural=my-talker\n"
      "  bimodal check words414 --without V_nat\n"
      "  bimodal check my-experiment.json");
  auto choice = std::make_shared<ProtocolChoice>();
  add_protocol_options(*verb, *choice);
  verb->callback([choice, &chosen] { chosen = [choice] { return check(*choice); }; });
}

}  // namespace bimodal::runner
