#include "stimuli/corpus/take_folder.hpp"

#include <algorithm>
#include <set>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kTakes = "takes";
constexpr const char* kRejected = "rejected";
constexpr std::size_t kLongestName = 100;

void make_private_folder(const fs::path& folder) {
  if (fs::is_directory(folder)) return;
  if (!folder.parent_path().empty()) fs::create_directories(folder.parent_path());
  if (::mkdir(folder.c_str(), S_IRWXU) != 0) refuse_to_write_takes(folder);
}

void make_private(const fs::path& file) {
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
}

double seconds(Duration time) {
  return std::chrono::duration<double>{time}.count();
}

/// A word as a part of a file's name.
std::string file_stem(std::string_view word) {
  std::string stem;
  for (const char letter : word.substr(0, kLongestName)) {
    const auto code = static_cast<unsigned char>(letter);
    const bool is_plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                          (letter >= '0' && letter <= '9') || letter == '-' || letter == '\'' ||
                          code >= 0x80;
    stem += is_plain ? letter : '_';
  }
  return stem.empty() ? "_" : stem;
}

Json source_json(const TakeSource& source) {
  return {{"started_utc", source.started_utc},
          {"device", source.device},
          {"simulated", source.simulated}};
}

fs::path text_beside(fs::path recording) {
  return recording.replace_extension(".txt");
}

void move_if_there(const fs::path& from, const fs::path& to) {
  if (fs::exists(from)) fs::rename(from, to);
}

}  // namespace

TakeFolder::TakeFolder(fs::path folder) : folder_{std::move(folder)} {
  try {
    if (fs::is_directory(folder_) && !fs::is_empty(folder_) &&
        !fs::exists(folder_ / TakeJournal::kName)) {
      refuse_takes(folder_, "it is in use for something else", "name a new folder");
    }
    make_private_folder(folder_);
    make_private_folder(folder_ / kTakes);
    make_private_folder(folder_ / kRejected);
    journal_.emplace(folder_);
    takes_ = journal_->read();
    mend();
  } catch (const fs::filesystem_error& error) {
    refuse_takes(
        folder_, error.code().message(), "check the folder, its permissions and free space");
  }
}

/// Ends what an interruption has left half done: puts every take where it belongs, and takes that
/// the journal does not know aside.
void TakeFolder::mend() {
  std::set<std::string> known;
  for (auto& take : takes_) {
    place(take);
    known.insert(take.file);
    // What somebody has removed does not count.
    if (take.counts) take.counts = fs::exists(folder_ / kTakes / take.file);
  }
  std::vector<fs::path> strange;
  for (const auto& entry : fs::directory_iterator{folder_ / kTakes}) {
    const auto& file = entry.path();
    const bool is_strange = file.extension() == ".wav" && !known.contains(file.filename().string());
    if (is_strange || file.extension() == ".part") strange.push_back(file);
  }
  for (const auto& file : strange) {
    if (file.extension() == ".part") {
      fs::remove(file);
      continue;
    }
    const auto aside = folder_ / kRejected / free_name(file.stem().string() + "-unfinished");
    fs::rename(file, aside);
    move_if_there(text_beside(file), text_beside(aside));
  }
}

void TakeFolder::place(const StoredTake& take) {
  const auto here = folder_ / (take.counts ? kTakes : kRejected) / take.file;
  const auto there = folder_ / (take.counts ? kRejected : kTakes) / take.file;
  if (!fs::exists(there)) return;
  move_if_there(text_beside(there), text_beside(here));
  fs::rename(there, here);
  sync_folder(folder_ / kTakes);
  sync_folder(folder_ / kRejected);
}

std::vector<std::string> TakeFolder::good_takes_of(std::string_view word) const {
  std::vector<std::string> files;
  for (const auto& take : takes_) {
    if (take.counts && take.word == word) files.push_back(take.file);
  }
  return files;
}

std::string TakeFolder::free_name(const std::string& word) const {
  const auto stem = file_stem(word);
  for (int number = 1;; ++number) {
    const auto name = number == 1 ? stem + ".wav" : fmt::format("{}-{}.wav", stem, number);
    const bool is_known = std::ranges::find(takes_, name, &StoredTake::file) != takes_.end();
    if (!is_known && !fs::exists(folder_ / kTakes / name) &&
        !fs::exists(folder_ / kRejected / name)) {
      return name;
    }
  }
}

void TakeFolder::write_down(const fs::path& file, const Clip& sound) const {
  write_wav(file, sound);
  make_private(file);
}

void TakeFolder::begin_session(std::string_view settings_json, const TakeSource& source) {
  Json line{{"event", "session"}};
  line.update(source_json(source));
  line["settings"] = Json::parse(settings_json);
  journal_->append(line.dump());
}

void TakeFolder::add_room(const Clip& room, Decibels level, const TakeSource& source) {
  auto file = folder_ / "room.wav";
  for (int number = 2; fs::exists(file); ++number) {
    file = folder_ / fmt::format("room-{}.wav", number);
  }
  write_down(file, room);
  sync_folder(folder_);
  Json line{{"event", "room"},
            {"file", file.filename().string()},
            {"sha256", sha256_of_file(file)},
            {"level_dbfs", level.count()},
            {"rate_hz", room.rate.count()}};
  line.update(source_json(source));
  journal_->append(line.dump());
}

std::string TakeFolder::add(const std::string& word,
                            const Clip& take,
                            const TakeMeasures& measures,
                            std::int64_t lost,
                            const std::vector<TakeFault>& faults,
                            const TakeSource& source,
                            const std::string& replaced) {
  const StoredTake stored{word, free_name(word), faults.empty()};
  const auto place = folder_ / (stored.counts ? kTakes : kRejected);
  const auto file = place / stored.file;
  write_down(file, take);
  write_file(text_beside(file), word + "\n");
  make_private(text_beside(file));
  sync_folder(place);
  Json line{{"event", "take"},
            {"word", word},
            {"file", stored.file},
            {"sha256", sha256_of_file(file)},
            {"verdict", stored.counts ? "good" : "doubtful"},
            {"faults", Json::array()},
            {"level_dbfs", measures.level.count()},
            {"peak_dbfs", measures.peak.count()},
            {"snr_db", measures.snr.count()},
            {"clipped_samples", measures.clipped},
            {"lost_samples", lost},
            {"duration_s", seconds(measures.duration)},
            {"rate_hz", take.rate.count()}};
  for (const auto fault : faults) line["faults"].push_back(name(fault));
  if (measures.speech) {
    line["speech_start_s"] = seconds(measures.speech->start);
    line["speech_end_s"] = seconds(measures.speech->end);
  }
  const bool replaces = stored.counts && !replaced.empty();
  if (replaces) line["replaced"] = take_named(replaced).file;
  line.update(source_json(source));
  journal_->append(line.dump());
  takes_.push_back(stored);
  if (replaces) set_counts(replaced, false);
  return stored.file;
}

StoredTake& TakeFolder::take_named(const std::string& file) {
  const auto found = std::ranges::find(takes_, file, &StoredTake::file);
  if (found != takes_.end()) return *found;
  throw Error{fmt::format("there is no take '{}' in '{}'", file, folder_.string())};
}

/// As the journal has it already.
void TakeFolder::set_counts(const std::string& file, bool counts) {
  auto& take = take_named(file);
  take.counts = counts;
  place(take);
}

void TakeFolder::keep(const std::string& file, const std::string& replaced) {
  Json line{{"event", "keep"}, {"file", take_named(file).file}};
  if (!replaced.empty()) line["replaced"] = take_named(replaced).file;
  journal_->append(line.dump());
  set_counts(file, true);
  if (!replaced.empty()) set_counts(replaced, false);
}

void TakeFolder::reject(const std::string& file) {
  journal_->append(Json{{"event", "reject"}, {"file", take_named(file).file}}.dump());
  set_counts(file, false);
}

}  // namespace bimodal
