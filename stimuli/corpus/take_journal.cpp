#include "stimuli/corpus/take_journal.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <variant>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/json_text.hpp"

namespace bimodal {

namespace fs = std::filesystem;

void refuse_takes(const fs::path& place, std::string_view finding, std::string_view remedy) {
  throw Error{fmt::format("cannot keep takes in '{}': {}; {}", place.string(), finding, remedy)};
}

void refuse_to_write_takes(const fs::path& place) {
  refuse_takes(place,
               std::error_code{errno, std::generic_category()}.message(),
               "check the folder, its permissions and free space");
}

void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) refuse_to_write_takes(folder);
  const int outcome = ::fsync(descriptor);
  ::close(descriptor);
  if (outcome != 0) refuse_to_write_takes(folder);
}

namespace {

bool is_file_name(const std::string& name) {
  return !name.empty() && name.find('/') == std::string::npos && name.ends_with(".wav");
}

/// Adds what a line of the journal in `folder` says to the takes.
void read_line(std::vector<StoredTake>& takes,
               std::string_view line,
               std::size_t number,
               const fs::path& folder) {
  const auto damaged = [&](std::string_view finding) {
    return Error{
        fmt::format("cannot go on in '{}': line {} of {} {}; the recordings are in takes/, keep a "
                    "copy and repair "
                    "or remove the line",
                    folder.string(),
                    number,
                    TakeJournal::kName,
                    finding)};
  };
  const auto parsed = parse_json(line);
  const auto* const json = std::get_if<nlohmann::json>(&parsed);
  if (json == nullptr || !json->is_object()) throw damaged("is no JSON object");
  const auto text = [&](const char* key) {
    const auto found = json->find(key);
    if (found == json->end() || !found->is_string()) {
      throw damaged(fmt::format("has no text \"{}\"", key));
    }
    return found->get<std::string>();
  };
  const auto event = text("event");
  if (event != "take" && event != "keep" && event != "reject") return;
  const auto file = text("file");
  if (!is_file_name(file)) throw damaged("names no WAV file");
  const auto set = [&](const std::string& named, bool counts) {
    const auto found = std::ranges::find(takes, named, &StoredTake::file);
    if (found == takes.end()) throw damaged("names a take that there is not");
    found->counts = counts;
  };
  if (json->contains("replaced")) set(text("replaced"), false);
  if (event == "take") {
    takes.push_back({text("word"), file, text("verdict") == "good"});
  } else {
    set(file, event == "keep");
  }
}

}  // namespace

TakeJournal::TakeJournal(fs::path folder) : folder_{std::move(folder)} {
  const auto file = folder_ / kName;
  descriptor_ = ::open(file.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (descriptor_ < 0) refuse_to_write_takes(file);
  try {
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      refuse_takes(folder_, "somebody is recording into it", "wait until that has ended");
    }
    sync_folder(folder_);
  } catch (const Error&) {
    ::close(descriptor_);
    throw;
  }
}

TakeJournal::~TakeJournal() {
  ::close(descriptor_);
}

std::vector<StoredTake> TakeJournal::read() {
  std::vector<StoredTake> takes;
  const auto content = read_file(folder_ / kName);
  std::size_t at = 0;
  for (std::size_t number = 1;; ++number) {
    const auto end = content.find('\n', at);
    if (end == std::string::npos) break;
    read_line(takes, std::string_view{content}.substr(at, end - at), number, folder_);
    at = end + 1;
  }
  if (at < content.size() && ::ftruncate(descriptor_, static_cast<off_t>(at)) != 0) {
    refuse_to_write_takes(folder_ / kName);
  }
  return takes;
}

void TakeJournal::append(std::string_view line) {
  const std::string whole = fmt::format("{}\n", line);
  const auto written = ::write(descriptor_, whole.data(), whole.size());
  if (written != static_cast<ssize_t>(whole.size()) || ::fdatasync(descriptor_) != 0) {
    refuse_to_write_takes(folder_ / kName);
  }
}

}  // namespace bimodal
