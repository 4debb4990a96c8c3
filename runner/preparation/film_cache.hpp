#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "runner/preparation/frame_source.hpp"

namespace bimodal::runner {

/// Drawn films that are kept on the disk from session to session, each in a file named by its key
/// (see film_key). Any number of processes may share a folder; in a process, one thread. What is
/// damaged is removed and not given out. The folder is private (0700): one that belongs to somebody
/// else, or that others may write to, is not used. A cache that cannot be read or written is as if
/// it were empty: the film is drawn.
class FilmCache {
 public:
  static constexpr std::uintmax_t kMostBytes = std::uintmax_t{4} << 30U;

  /// At most `most_bytes` are kept: the films that have not been used for longest go first.
  explicit FilmCache(std::filesystem::path folder, std::uintmax_t most_bytes = kMostBytes);

  /// The very film that was kept under this key; absent if there is none. `checkpoint` is called
  /// between its pictures.
  [[nodiscard]] std::optional<Film> find(const std::string& key,
                                         const Checkpoint& checkpoint) const;

  /// The bytes that a kept film takes, which counts as used now; absent if there is none, or
  /// one without an end, as a power cut leaves it. Does not look at what else is in it.
  [[nodiscard]] std::optional<std::uintmax_t> use(const std::string& key) const;

  [[nodiscard]] std::uintmax_t most_bytes() const { return most_bytes_; }

  /// Keeps a film, if there is room for it.
  void keep(const std::string& key, const Film& film, const Checkpoint& checkpoint) const;

 private:
  [[nodiscard]] bool make_folder() const;
  [[nodiscard]] std::filesystem::path file_of(const std::string& key) const;
  void make_room(std::uintmax_t needed) const;

  std::filesystem::path folder_;
  std::uintmax_t most_bytes_;
};

/// Where the films of this user are kept: below $BIMODAL_CACHE, else $XDG_CACHE_HOME/bimodal, else
/// ~/.cache/bimodal. Absent if there is none of these, or BIMODAL_CACHE is empty.
[[nodiscard]] std::optional<std::filesystem::path> film_cache_folder();

}  // namespace bimodal::runner
