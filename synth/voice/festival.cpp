#include "synth/voice/festival.hpp"

#include <algorithm>
#include <cassert>
#include <exception>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <utility>

#include <festival.h>
#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::synth {

namespace {

constexpr int kHeapCells = 2'100'000;  // Festival's own default on Debian
constexpr const char* kText = "bimodal_text";
constexpr const char* kUtterance = "bimodal_utterance";
constexpr const char* kSpeakText =
    "(set! bimodal_utterance (utt.synth (eval (list 'Utterance 'Text bimodal_text))))";
constexpr const char* kSpeakWord =
    "(set! bimodal_utterance (utt.synth (Utterance Words (bimodalword))))";

// Festival's kal says AH with the diphones of AA, so that "cut" and "cot" sound alike (its rule
// kal_diphone_fix_phone_name), although its inventory has all diphones of AH. Here it uses them.
constexpr const char* kOwnAh =
    "(define (bimodal_own_ah utt)"
    "  (mapcar (lambda (seg)"
    "            (if (string-equal \"ah\" (item.name seg)) (item.set_feat seg 'us_diphone \"ah\")))"
    "          (utt.relation.items utt 'Segment))"
    "  utt)";
constexpr const char* kUseOwnAh =
    "(set! UniSyn_module_hooks (list kal_diphone_const_clusters bimodal_own_ah))";

// Festival's mapping of pitch marks reads the time of one mark more than there are, and what lies
// in memory there decides how the end of a word sounds. So a mark that is never the nearest is put
// behind the last before it maps.
constexpr const char* kGuardedMapping =
    "(begin"
    "  (set! bimodal_mapping us_mapping)"
    "  (define (us_mapping utt method)"
    "    (bimodal_guard utt)"
    "    (bimodal_mapping utt method)))";
constexpr float kNeverNearest = 1e6F;  // s

LISP add_guard(LISP of_utterance) {
  EST_Utterance* const spoken = utterance(of_utterance);
  if (spoken->relation_present("SourceCoef") == 0) return of_utterance;
  EST_Item* const item = spoken->relation("SourceCoef")->head();
  if (item == nullptr || item->f_present("coefs") == 0) return of_utterance;
  EST_Track& marks = *track(item->f("coefs"));
  const int count = marks.num_frames();
  marks.resize(count + 1, marks.num_channels());
  marks.t(count) = kNeverNearest;
  return of_utterance;
}

/// What Festival prints while it lives goes here, and not onto the user's terminal.
class CapturedStreams {
 public:
  CapturedStreams() : out_{std::cout.rdbuf(text_.rdbuf())}, err_{std::cerr.rdbuf(text_.rdbuf())} {}

  ~CapturedStreams() {
    std::cout.rdbuf(out_);
    std::cerr.rdbuf(err_);
  }

  CapturedStreams(const CapturedStreams&) = delete;
  CapturedStreams& operator=(const CapturedStreams&) = delete;
  CapturedStreams(CapturedStreams&&) = delete;
  CapturedStreams& operator=(CapturedStreams&&) = delete;

  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::streambuf* out_;
  std::streambuf* err_;
};

/// Evaluates Scheme source of ours, never of a user's. False if Festival reports an error.
bool evaluates(const std::string& command) {
  return festival_eval_command(EST_String{command.c_str()}) != 0;
}

[[maybe_unused]] bool made_of_letters(std::string_view symbol) {
  return std::ranges::all_of(symbol, [](char c) { return c >= 'a' && c <= 'z'; });
}

/// The last utterance's first sound; nullptr if it has none.
const EST_Wave* wave_of(EST_Utterance& utterance) {
  if (utterance.relation_present("Wave") == 0) return nullptr;
  EST_Item* const item = utterance.relation("Wave")->head();
  if (item == nullptr || item->f_present("wave") == 0) return nullptr;
  return wave(item->f("wave"));
}

FestivalSpeech copied(EST_Utterance& utterance, const EST_Wave& sound) {
  FestivalSpeech speech{.rate_hz = sound.sample_rate(), .samples = {}, .segments = {}};
  speech.samples.reserve(static_cast<std::size_t>(sound.num_samples()));
  for (int i = 0; i < sound.num_samples(); ++i) speech.samples.push_back(sound.a(i));
  for (EST_Item* item = utterance.relation("Segment")->head(); item != nullptr;
       item = inext(item)) {
    const EST_String symbol = item->S("name");
    speech.segments.push_back({.symbol = static_cast<const char*>(symbol),
                               .end_s = static_cast<double>(item->F("end", -1.0F))});
  }
  return speech;
}

}  // namespace

Festival& Festival::shared() {
  static Festival festival;
  return festival;
}

Festival::Festival() : thread_{[this] { serve(); }} {
  try {
    run([this] { start(); });
  } catch (...) {
    {
      const std::scoped_lock lock{mutex_};
      stopping_ = true;
    }
    changed_.notify_all();
    thread_.join();
    throw;
  }
}

Festival::~Festival() {
  {
    const std::scoped_lock lock{mutex_};
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Festival::run(std::function<void()> job) {
  std::exception_ptr failure;
  bool done = false;
  std::unique_lock lock{mutex_};
  jobs_.emplace_back([&] {
    try {
      job();
    } catch (...) {
      failure = std::current_exception();
    }
    const std::scoped_lock finished{mutex_};
    done = true;
  });
  changed_.notify_all();
  changed_.wait(lock, [&done] { return done; });
  if (failure) std::rethrow_exception(failure);
}

void Festival::serve() {
  for (;;) {
    std::function<void()> job;
    {
      std::unique_lock lock{mutex_};
      changed_.wait(lock, [this] { return stopping_ || !jobs_.empty(); });
      if (jobs_.empty()) return;
      job = std::move(jobs_.front());
      jobs_.erase(jobs_.begin());
    }
    job();
    changed_.notify_all();
  }
}

void Festival::start() {
  const auto start_up_file = std::filesystem::path{festival_datadir} / "init.scm";
  if (!std::filesystem::exists(start_up_file)) {
    throw Error{
        fmt::format("cannot start Festival: '{}' is missing; install the Debian packages"
                    " festival, festlex-cmu and festlex-poslex",
                    start_up_file.string())};
  }
  const CapturedStreams captured;
  festival_initialize(0, kHeapCells);
  init_subr_1("bimodal_guard", add_guard, "(bimodal_guard UTT) See kGuardedMapping.");
  // Set before init.scm looks for the start-up files of user and site below these folders.
  const bool ready = evaluates("(set! home-directory \"/nonexistent\")") &&
                     evaluates("(set! sysconfdir \"/nonexistent\")") &&
                     evaluates("(load (path-append datadir \"init.scm\"))") && evaluates(kOwnAh) &&
                     evaluates(kGuardedMapping) && evaluates(fmt::format("(set! {} nil)", kText));
  if (!ready) {
    throw Error{fmt::format(
        "cannot start Festival from '{}': {}", start_up_file.string(), captured.text())};
  }
}

std::string Festival::version() {
  const std::string whole{festival_version};  // "2.5.0:release December 2017"
  return whole.substr(0, whole.find(':'));
}

bool Festival::has_voice(std::string_view voice) {
  bool found = false;
  run([&] { found = siod_get_lval(std::string{voice}.c_str(), nullptr) != NIL; });
  return found;
}

FestivalSpeech Festival::speak_text(std::string_view voice, std::string_view text) {
  FestivalSpeech speech;
  run([&] {
    // The variable exists, so that setting it allocates nothing that could collect the new string.
    siod_set_lval(kText, strintern(std::string{text}.c_str()));
    speech = synthesise(voice, kSpeakText);
  });
  return speech;
}

FestivalSpeech Festival::speak_phones(std::string_view voice,
                                      const std::vector<std::string_view>& symbols) {
  assert(std::ranges::all_of(symbols, made_of_letters));
  const auto entry =
      fmt::format("(lex.add.entry '(\"bimodalword\" n ((({}) 1))))", fmt::join(symbols, " "));
  FestivalSpeech speech;
  run([&] {
    select(voice);  // first, because the entry goes into the voice's lexicon
    if (const CapturedStreams captured; !evaluates(entry)) {
      throw Error{fmt::format("Festival does not take the pronunciation ({}): {}",
                              fmt::join(symbols, " "),
                              captured.text())};
    }
    speech = synthesise(voice, kSpeakWord);
  });
  return speech;
}

void Festival::select(std::string_view voice) {
  if (current_voice_ == voice) return;
  const CapturedStreams captured;
  current_voice_.clear();
  const bool selected = evaluates(fmt::format("({})", voice)) &&
                        (voice != "voice_kal_diphone" || evaluates(kUseOwnAh));
  if (!selected) {
    throw Error{fmt::format("Festival cannot select its voice '{}': {}", voice, captured.text())};
  }
  current_voice_ = voice;
}

FestivalSpeech Festival::synthesise(std::string_view voice, const char* command) {
  select(voice);
  const CapturedStreams captured;
  siod_set_lval(kUtterance, NIL);
  const bool spoken = evaluates(command);
  const LISP made = siod_get_lval(kUtterance, nullptr);
  EST_Utterance* const utt = spoken && utterance_p(made) != 0 ? utterance(made) : nullptr;
  const EST_Wave* const sound = utt == nullptr ? nullptr : wave_of(*utt);
  if (sound == nullptr || sound->num_samples() == 0 || utt->relation_present("Segment") == 0) {
    throw Error{fmt::format("Festival's voice '{}' gave no sound. {}", voice, captured.text())};
  }
  if (captured.text().find("default diphone") != std::string::npos) {
    throw Error{fmt::format(
        "Festival's voice '{}' has no sound for a joint of two phones and would say another: {}",
        voice,
        captured.text())};
  }
  return copied(*utt, *sound);
}

}  // namespace bimodal::synth
