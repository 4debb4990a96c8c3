#include "runner/preparation/film_cache.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

#include "runner/preparation/film_file.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

namespace fs = std::filesystem;

constexpr auto kEnding = ".film";
/// What a process leaves behind that was killed while it wrote.
constexpr auto kDraftEnding = ".part";
constexpr std::chrono::hours kOldestDraft{1};

/// Nobody else can have put films there.
bool is_private(const fs::path& folder) {
  struct stat found {};

  constexpr mode_t kOthersWrite = S_IWGRP | S_IWOTH;
  return ::stat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) &&
         found.st_uid == ::geteuid() && (found.st_mode & kOthersWrite) == 0;
}

/// Whether the file ends as every film does.
bool has_end(const fs::path& file) {
  std::ifstream stream{file, std::ios::binary};
  stream.seekg(-static_cast<std::streamoff>(kFilmDigest), std::ios::end);
  std::array<char, kFilmDigest> end{};
  stream.read(end.data(), end.size());
  constexpr std::string_view kDigits = "0123456789abcdef";
  return stream && std::ranges::all_of(end, [&](char digit) {
           return kDigits.find(digit) != std::string_view::npos;
         });
}

struct KeptFile {
  fs::path path;
  fs::file_time_type used;
  std::uintmax_t bytes = 0;
};

/// The films of a folder, the one that has not been used for longest first; removes old drafts.
std::vector<KeptFile> kept_files(const fs::path& folder) {
  std::vector<KeptFile> files;
  std::error_code fault;
  const auto now = fs::file_time_type::clock::now();
  for (fs::directory_iterator it{folder, fault}, end; !fault && it != end; it.increment(fault)) {
    std::error_code gone;  // another process may have removed it
    const auto used = it->last_write_time(gone);
    const auto bytes = gone ? 0 : it->file_size(gone);
    if (gone) continue;
    const auto ending = it->path().extension();
    if (ending == kEnding) files.push_back({it->path(), used, bytes});
    if (ending == kDraftEnding && now - used > kOldestDraft) fs::remove(it->path(), gone);
  }
  std::ranges::sort(files, {}, &KeptFile::used);
  return files;
}

std::optional<fs::path> folder_named(const char* variable) {
  const char* const value = std::getenv(variable);
  if (value == nullptr || *value == '\0') return std::nullopt;
  return fs::path{value};
}

}  // namespace

FilmCache::FilmCache(fs::path folder, std::uintmax_t most_bytes)
    : folder_{std::move(folder)}, most_bytes_{most_bytes} {}

std::optional<Film> FilmCache::find(const std::string& key, const Checkpoint& checkpoint) const {
  const auto file = file_of(key);
  std::error_code fault;
  if (!is_private(folder_) || !fs::is_regular_file(file, fault)) return std::nullopt;
  std::optional<Film> film;
  try {
    film = unpacked(read_file(file), key, checkpoint);
  } catch (const Error&) {
    return std::nullopt;
  }
  if (film) {
    fs::last_write_time(file, fs::file_time_type::clock::now(), fault);
  } else {
    fs::remove(file, fault);
  }
  return film;
}

std::optional<std::uintmax_t> FilmCache::use(const std::string& key) const {
  const auto file = file_of(key);
  std::error_code fault;
  if (!is_private(folder_) || !fs::is_regular_file(file, fault)) return std::nullopt;
  if (!has_end(file)) return std::nullopt;
  fs::last_write_time(file, fs::file_time_type::clock::now(), fault);
  const auto bytes = fs::file_size(file, fault);
  if (fault) return std::nullopt;
  return bytes;
}

void FilmCache::keep(const std::string& key, const Film& film, const Checkpoint& checkpoint) const {
  if (!make_folder()) return;
  const auto bytes = packed(film, key, checkpoint);
  if (bytes.size() > most_bytes_) return;
  make_room(bytes.size());
  try {
    write_file(file_of(key), bytes, Durability::Later);  // answers do not wait for films
    fs::permissions(file_of(key), fs::perms::owner_read | fs::perms::owner_write);
  } catch (const Error&) {
    return;  // the disk is full: the film is drawn anew next time
  } catch (const fs::filesystem_error&) {
    return;  // another process has removed it already
  }
}

bool FilmCache::make_folder() const {
  std::error_code fault;
  fs::create_directories(folder_.parent_path(), fault);
  if (::mkdir(folder_.c_str(), S_IRWXU) != 0 && errno != EEXIST) return false;
  return is_private(folder_);
}

fs::path FilmCache::file_of(const std::string& key) const {
  return folder_ / (key + kEnding);
}

void FilmCache::make_room(std::uintmax_t needed) const {
  const auto files = kept_files(folder_);
  std::uintmax_t total = needed;
  for (const auto& file : files) total += file.bytes;
  for (const auto& file : files) {
    if (total <= most_bytes_) return;
    std::error_code gone;
    fs::remove(file.path, gone);
    total -= file.bytes;
  }
}

std::optional<fs::path> film_cache_folder() {
  if (std::getenv("BIMODAL_CACHE") != nullptr) {
    const auto own = folder_named("BIMODAL_CACHE");
    return own ? std::optional{*own / "films"} : std::nullopt;
  }
  if (const auto cache = folder_named("XDG_CACHE_HOME")) return *cache / "bimodal" / "films";
  if (const auto home = folder_named("HOME")) return *home / ".cache" / "bimodal" / "films";
  return std::nullopt;
}

}  // namespace bimodal::runner
