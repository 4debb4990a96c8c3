#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bimodal {

/// A take that is stored.
struct StoredTake {
  std::string word;
  std::string file;     ///< its name in the folder of takes, or of rejected ones: "stew-2.wav"
  bool counts = false;  ///< it is good, or was kept, and was not rejected since
};

/// takes.jsonl of a TakeFolder: one line of JSON for each thing that happened, never changed, only
/// added to. One process at a time may have it open.
class TakeJournal {
 public:
  static constexpr const char* kName = "takes.jsonl";

  /// Opens or makes it, readable by its owner only. Throws Error if that cannot be, or another
  /// process has it open.
  explicit TakeJournal(std::filesystem::path folder);
  TakeJournal(const TakeJournal&) = delete;
  TakeJournal& operator=(const TakeJournal&) = delete;
  TakeJournal(TakeJournal&&) = delete;
  TakeJournal& operator=(TakeJournal&&) = delete;
  ~TakeJournal();

  /// All takes, in the order in which they were made. An unfinished last line is taken away: it was
  /// being written when the power failed. Throws Error, naming it, if another is damaged.
  [[nodiscard]] std::vector<StoredTake> read();

  /// Returns when the disk has the line.
  void append(std::string_view line);

 private:
  std::filesystem::path folder_;
  int descriptor_ = -1;
};

/// Throws Error about a folder of takes, or a file in it.
[[noreturn]] void refuse_takes(const std::filesystem::path& place,
                               std::string_view finding,
                               std::string_view remedy);

/// The same, for the reason that errno has.
[[noreturn]] void refuse_to_write_takes(const std::filesystem::path& place);

/// Waits until the disk knows which files a folder has.
void sync_folder(const std::filesystem::path& folder);

}  // namespace bimodal
