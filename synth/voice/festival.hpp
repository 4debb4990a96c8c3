#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace bimodal::synth {

/// One segment as Festival made it.
struct FestivalSegment {
  std::string symbol;  ///< of the voice's phone set, e.g. "uw", "pau"
  double end_s = 0;    ///< seconds from the start of the sound
};

struct FestivalSpeech {
  int rate_hz = 0;
  std::vector<std::int16_t> samples;
  std::vector<FestivalSegment> segments;  ///< in order; each begins where the one before ends
};

/// The Festival interpreter, of which a process can have only one: its state is global, it is not
/// thread-safe, and its garbage collector scans the stack of the thread that initialised it. So it
/// lives on a thread of its own, on which all callers' requests are done one after the other; this
/// is the one process-wide object of the project.
///
/// It reads no start-up files of the user or the site (~/.festivalrc, /etc/festival.scm), which
/// could change how a word sounds. While a request is done, std::cout and std::cerr are Festival's
/// and what it prints there ends up in the message of an Error, if there is one.
class Festival {
 public:
  /// Starts Festival at the first call. Throws Error if its files are not installed.
  [[nodiscard]] static Festival& shared();

  ~Festival();
  Festival(const Festival&) = delete;
  Festival& operator=(const Festival&) = delete;
  Festival(Festival&&) = delete;
  Festival& operator=(Festival&&) = delete;

  /// E.g. "2.5.0".
  [[nodiscard]] std::string version();

  /// Whether a voice is installed, by its procedure's name, e.g. "voice_kal_diphone".
  [[nodiscard]] bool has_voice(std::string_view voice);

  /// Speaks `text`, which Festival's tokenizer, lexicon and letter-to-sound rules read. The text
  /// is handed over as a string object, never as Scheme source. Precondition: printable ASCII with
  /// a letter or digit. Throws Error if there is no sound.
  [[nodiscard]] FestivalSpeech speak_text(std::string_view voice, std::string_view text);

  /// Speaks one content word of one stressed syllable that consists of `symbols`, as the lexicon
  /// would have it. Precondition: symbols of the phone set "radio". Throws Error if there is no
  /// sound, or if the voice lacks a joint between two of the phones.
  [[nodiscard]] FestivalSpeech speak_phones(std::string_view voice,
                                            const std::vector<std::string_view>& symbols);

 private:
  Festival();

  /// Does `job` on Festival's thread and returns when it is done; passes on what it throws.
  void run(std::function<void()> job);
  void serve();

  void start();
  void select(std::string_view voice);
  FestivalSpeech synthesise(std::string_view voice, const char* command);

  std::string current_voice_;  ///< touched by Festival's thread only

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::function<void()>> jobs_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace bimodal::synth
