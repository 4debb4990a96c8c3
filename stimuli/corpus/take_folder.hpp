#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/audio/clip.hpp"
#include "stimuli/audio/take_check.hpp"
#include "stimuli/corpus/take_journal.hpp"

namespace bimodal {

/// With what and when something was recorded.
struct TakeSource {
  std::string started_utc;
  std::string device;      ///< its description
  bool simulated = false;  ///< no microphone
};

/// The folder of a talker's recorded words. It holds
///  - takes/: the takes that count: WORD.wav (WORD-2.wav ...: later takes) and WORD.txt, what is
///    said in it, as `bimodal corpus build` reads it;
///  - rejected/: the other takes;
///  - room.wav: the silence of the room (room-2.wav ...: of later sessions);
///  - takes.jsonl: one line of JSON for each thing that happened, never changed, only added to.
/// Each call returns when the disk has everything, so that a power cut loses only what had not been
/// stored yet; opening the folder again mends what was being done. All is readable by its owner
/// only: a voice is personal. One process at a time may use it.
class TakeFolder {
 public:
  /// Opens or makes it. Throws Error, with what to do, if it cannot be made, another process uses
  /// it, it holds other things and no takes.jsonl, or a line of that is damaged (the last one, if
  /// unfinished, is taken away: it was being written when the power failed).
  explicit TakeFolder(std::filesystem::path folder);
  TakeFolder(const TakeFolder&) = delete;
  TakeFolder& operator=(const TakeFolder&) = delete;
  TakeFolder(TakeFolder&&) = delete;
  TakeFolder& operator=(TakeFolder&&) = delete;
  ~TakeFolder() = default;

  /// All takes, in the order in which they were made.
  [[nodiscard]] const std::vector<StoredTake>& takes() const { return takes_; }

  /// The files of the takes of a word that count, in order.
  [[nodiscard]] std::vector<std::string> good_takes_of(std::string_view word) const;

  /// Notes that a session begins: what is to be read and in which order. `settings` is JSON.
  void begin_session(std::string_view settings_json, const TakeSource& source);

  void add_room(const Clip& room, Decibels level, const TakeSource& source);

  /// Stores a take (32-bit float WAV: the very samples); it counts if it has no faults, and then
  /// `replaced` (a file; empty: none) does so no longer: both or neither. Returns its file's name.
  std::string add(const std::string& word,
                  const Clip& take,
                  const TakeMeasures& measures,
                  std::int64_t lost,
                  const std::vector<TakeFault>& faults,
                  const TakeSource& source,
                  const std::string& replaced = {});

  /// From now on the take counts, and `replaced` (empty: none) does so no longer. Throws Error if
  /// there is no such take.
  void keep(const std::string& file, const std::string& replaced = {});

  /// From now on the take does not count. Throws Error if there is none.
  void reject(const std::string& file);

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

 private:
  void mend();
  void place(const StoredTake& take);
  void write_down(const std::filesystem::path& file, const Clip& sound) const;
  [[nodiscard]] StoredTake& take_named(const std::string& file);
  [[nodiscard]] std::string free_name(const std::string& word) const;
  void set_counts(const std::string& file, bool counts);

  std::filesystem::path folder_;
  std::optional<TakeJournal> journal_;  ///< absent only while the folder is being opened
  std::vector<StoredTake> takes_;
};

}  // namespace bimodal
