#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "runner/cli/corpus_verbs.hpp"
#include "runner/cli/interrupt.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/cli/recording_loop.hpp"
#include "runner/cli/session_setup.hpp"
#include "runner/cli/simulated_talker.hpp"
#include "runner/devices/headless/headless_display.hpp"
#include "runner/devices/monotonic_clock.hpp"
#include "runner/devices/portaudio/portaudio_input.hpp"
#include "runner/devices/sdl/sdl_display.hpp"
#include "runner/devices/sdl/sdl_keyboard.hpp"
#include "runner/devices/simulated/simulated_display.hpp"
#include "runner/devices/simulated/simulated_keyboard.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal::runner {

namespace {

constexpr std::string_view kSimulated = "simulated:";
constexpr Colour kPaper{0.94F, 0.94F, 0.92F};

struct RecordOptions {
  std::string list;
  std::vector<std::string> words;
  std::string output;
  std::string device;
  int rate = 48'000;
  std::string order = "list";
  Seed seed = 1;
  int repeats = 1;
  bool automatic = false;
  bool windowed = false;
  std::string input = "microphone";
  std::string display = "window";
  std::string answers = "typed";
};

/// In the order in which they must be closed.
struct Devices {
  std::unique_ptr<Clock> clock;
  std::unique_ptr<SdlWindow> window;
  std::unique_ptr<Display> display;
  std::unique_ptr<Keyboard> keyboard;
  std::unique_ptr<AudioInput> input;
};

bool is_simulated_input(const RecordOptions& options) {
  return options.input.starts_with(kSimulated);
}

void refuse_what_cannot_be(const RecordOptions& options) {
  if (options.list.empty() == options.words.empty()) {
    throw Error{"give the words to be recorded: either --words LIST or --word WORD, not both"};
  }
  if (options.input != "microphone" && !is_simulated_input(options)) {
    throw Error{
        fmt::format("there is no input '{}'; give --input microphone or --input simulated:FILE",
                    options.input)};
  }
  if (options.display == "headless" && options.answers == "typed") {
    throw Error{
        "nobody can press keys without a window; give --answers simulated with --display "
        "headless"};
  }
}

/// Each word once, in the order of the list.
std::vector<std::string> words_to_record(const RecordOptions& options) {
  std::vector<std::string> given = options.words;
  if (!options.list.empty()) {
    for (const auto& word : words_named(options.list).words) given.push_back(word.spelling);
  }
  std::set<std::string> known;
  std::vector<std::string> words;
  for (const auto& word : given) {
    constexpr std::size_t kLongest = 100;
    if (word.empty() || word.size() > kLongest || !is_utf8(word) ||
        word.find_first_of("\n\r\t") != std::string::npos) {
      throw Error{fmt::format(
          "cannot record the word '{}': it must be one line of 1 to {} letters", word, kLongest)};
    }
    if (known.insert(word).second) words.push_back(word);
  }
  return words;
}

/// Every word `repeats` times: the whole list, then the whole list again, each time in its own
/// order. The takes that count are given to the first slots of their words.
std::vector<WordSlot> slots_of(const std::vector<std::string>& words,
                               const RecordOptions& options,
                               const TakeFolder& folder) {
  std::vector<WordSlot> slots;
  for (int pass = 0; pass < options.repeats; ++pass) {
    auto order = words;
    if (options.order == "random") {
      Random random{derive_seed(options.seed, "reading order", {static_cast<std::uint64_t>(pass)})};
      shuffle(std::span{order}, random);
    }
    for (const auto& word : order) {
      const auto good = folder.good_takes_of(word);
      const auto index = static_cast<std::size_t>(pass);
      slots.push_back({word, index < good.size() ? good[index] : ""});
    }
  }
  return slots;
}

std::size_t done_of(const std::vector<WordSlot>& slots) {
  return static_cast<std::size_t>(
      std::ranges::count_if(slots, [](const WordSlot& slot) { return !slot.file.empty(); }));
}

bool all_done(const std::vector<WordSlot>& slots) {
  return done_of(slots) == slots.size();
}

std::unique_ptr<Devices> open_devices(const RecordOptions& options) {
  auto opened = std::make_unique<Devices>();
  auto& devices = *opened;
  const Hertz rate{static_cast<double>(options.rate)};
  const bool headless = options.display == "headless";
  // The microphone first: without one, no window need open.
  if (is_simulated_input(options)) {
    auto talker = talker_of(options.input.substr(kSimulated.size()), rate);
    if (headless) {
      // Nobody looks on and nobody speaks: time may pass as fast as it can.
      auto clock = std::make_unique<VirtualClock>();
      devices.display = std::make_unique<SimulatedDisplay>(*clock);
      devices.clock = std::move(clock);
    } else {
      devices.clock = std::make_unique<MonotonicClock>();
    }
    devices.input = std::make_unique<SimulatedInput>(*devices.clock, std::move(talker));
  } else {
    devices.clock = std::make_unique<MonotonicClock>();
    devices.input = std::make_unique<PortaudioInput>(
        PortaudioInputOptions{.device = options.device, .rate = rate});
    if (headless) devices.display = std::make_unique<HeadlessDisplay>();
  }
  if (!headless) {
    devices.window = std::make_unique<SdlWindow>(SdlWindow::Options{.width = 1280,
                                                                    .height = 800,
                                                                    .fullscreen = !options.windowed,
                                                                    .title = "Bimodal: recording",
                                                                    .background = kPaper});
    Screen opening;
    opening.captions = {{.text = "One moment, please ...", .centre_y = 0.42, .size = 0.04}};
    devices.display = std::make_unique<SdlDisplay>(*devices.window, opening);
  }
  if (options.answers == "simulated") {
    devices.keyboard = std::make_unique<SimulatedKeyboard>(*devices.clock);
  } else {
    devices.keyboard = std::make_unique<SdlKeyboard>(*devices.window, *devices.clock);
  }
  return opened;
}

std::string settings_of(const RecordOptions& options, const std::vector<std::string>& words) {
  return nlohmann::ordered_json{{"program", "bimodal " BIMODAL_VERSION},
                                {"list", options.list},
                                {"words", words.size()},
                                {"order", options.order},
                                {"seed", options.seed},
                                {"repeats", options.repeats},
                                {"automatic", options.automatic}}
      .dump();
}

void say(std::string_view what) {
  fmt::print("{}\n", what);
  std::fflush(stdout);
}

void say_what_next(const RecordOptions& options, bool complete) {
  if (!complete) {
    say("the same command goes on with the next word");
    return;
  }
  const auto list = options.list.empty() ? options.output + "/words.txt" : options.list;
  say(fmt::format(
      "next: bimodal corpus build {}/takes/*.wav --words {} -o CORPUS", options.output, list));
}

ExitCode record(const RecordOptions& options) {
  refuse_what_cannot_be(options);
  const auto words = words_to_record(options);
  // A voice is personal: whatever is made here is for its owner only.
  ::umask(S_IRWXG | S_IRWXO);
  // A new folder is made only when the devices are there; an old one may have everything already.
  std::unique_ptr<TakeFolder> opened;
  if (std::filesystem::exists(options.output)) {
    opened = std::make_unique<TakeFolder>(options.output);
    if (all_done(slots_of(words, options, *opened))) {
      say(fmt::format("{}: every word is recorded", options.output));
      say_what_next(options, true);
      return ExitCode::Done;
    }
  }
  const auto devices = open_devices(options);
  if (!opened) opened = std::make_unique<TakeFolder>(options.output);
  auto& folder = *opened;
  auto slots = slots_of(words, options, folder);
  const auto total = slots.size();
  say(fmt::format("{}: {} of {} recorded", options.output, done_of(slots), counted(total, "take")));
  say(devices->input->description());
  const bool simulated = is_simulated_input(options);
  folder.begin_session(settings_of(options, words),
                       {utc_now(), devices->input->description(), simulated});
  if (options.list.empty()) {
    write_file(folder.path() / "words.txt", fmt::format("{}\n", fmt::join(words, "\n")));
  }
  stop_at_interrupt();
  const auto outcome = record_words({.clock = *devices->clock,
                                     .display = *devices->display,
                                     .keyboard = *devices->keyboard,
                                     .input = *devices->input,
                                     .folder = folder,
                                     .rules = {.automatic = options.automatic},
                                     .simulated = simulated,
                                     .answers_itself = options.answers == "simulated",
                                     .interrupted = interrupt_asked,
                                     .announce = say},
                                    std::move(slots));
  say(fmt::format("{}: {} of {} recorded, in {}/takes",
                  outcome.complete ? "complete" : "stopped",
                  outcome.done,
                  counted(total, "take"),
                  options.output));
  say_what_next(options, outcome.complete);
  return outcome.complete ? ExitCode::Done : ExitCode::Findings;
}

}  // namespace

void add_corpus_record(CLI::App& corpus, Verb& chosen) {
  auto* const verb = corpus.add_subcommand(
      "record",
      "Records a talker who reads words aloud, one by one from the screen. Every take is judged "
      "at\n"
      "once (level, clipping, room, margins) and stored before the next word is shown; a doubtful\n"
      "one is asked for again. Started again, it goes on where it was.\n"
      "The folder: takes/WORD.wav and WORD.txt (what counts), rejected/, takes.jsonl, room.wav;\n"
      "only its owner can read it.\n"
      "Exit code: 0 all words are recorded, 1 stopped before, 3 bad input, 4 no microphone or "
      "screen.\n\n"
      "Keys: Space or Enter: record; ends a take, too. R or Backspace: the last one again. Left: "
      "the\n"
      "word before. S: pass over. K: keep a doubtful take. Escape: stop.\n\n"
      "Examples:\n"
      "  bimodal corpus record --words monosyllables-414 -o anna-takes\n"
      "  bimodal corpus record --words mine.json -o anna-takes --auto --order random --seed 7\n"
      "  bimodal corpus record --word stew --word zoo -o trial --windowed --input "
      "simulated:reading.wav");
  auto options = std::make_shared<RecordOptions>();
  verb->add_option(
      "--words",
      options->list,
      "the words: a word list (.json), the name of one of the project, or a text file");
  verb->add_option("--word", options->words, "a word to be recorded; may be given again")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  verb->add_option("-o,--output", options->output, "the folder of the takes; gone on with if there")
      ->required();
  verb->add_option("--device",
                   options->device,
                   "the microphone's name or number (see `bimodal devices`); else the default");
  verb->add_option("--rate", options->rate, "samples per second (48000)")
      ->check(CLI::Range(8'000, 192'000));
  verb->add_option("--order", options->order, "list (default) or random")
      ->check(CLI::IsMember({"list", "random"}));
  verb->add_option("--seed", options->seed, "of the random order (1)")->check(seed_number());
  verb->add_option("--repeats", options->repeats, "takes of each word: so many times the list (1)")
      ->check(whole_number_from(1));
  verb->add_flag("--auto", options->automatic, "go on from word to word without keys");
  verb->add_flag("--windowed", options->windowed, "a window instead of the full screen");
  verb->add_option("--input",
                   options->input,
                   "microphone (default), or simulated:FILE, a recording of words: for trying out");
  verb->add_option("--display", options->display, "window (default) or headless: nothing is shown")
      ->check(CLI::IsMember({"window", "headless"}));
  verb->add_option("--answers", options->answers, "typed (default), or simulated: keys by itself")
      ->check(CLI::IsMember({"typed", "simulated"}));
  verb->callback([options, &chosen] { chosen = [options] { return record(*options); }; });
}

}  // namespace bimodal::runner
