#include "stimuli/corpus/corpus_folder.hpp"

#include <system_error>
#include <variant>

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/json_text.hpp"
#include "stimuli/base/obstacle.hpp"
#include "stimuli/labels/label_file.hpp"

namespace bimodal {

namespace {

constexpr const char* kWritten = "written.json";

void make_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) {
    throw Error{fmt::format("cannot make the folder '{}': {}; choose another place for the corpus",
                            folder.string(),
                            failure.message())};
  }
}

}  // namespace

CorpusLabels::CorpusLabels(const std::filesystem::path& corpus) : folder_{corpus / "labels"} {
  const auto file = folder_ / kWritten;
  if (obstacle(file)) return;
  const auto parsed = parse_json(read_file(file));
  const auto* const json = std::get_if<nlohmann::json>(&parsed);
  if (json == nullptr || !json->is_object()) return;
  for (const auto& [name, digest] : json->items()) {
    if (digest.is_string()) written_[name] = digest.get<std::string>();
  }
}

std::filesystem::path CorpusLabels::file_of(const std::string& recording) const {
  return folder_ / (recording + ".TextGrid");
}

std::filesystem::path CorpusLabels::text_file_of(const std::string& recording) const {
  return folder_ / (recording + ".txt");
}

bool CorpusLabels::edited(const std::string& recording) const {
  const auto file = file_of(recording);
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return false;
  const auto known = written_.find(file.filename().string());
  return known == written_.end() || known->second != sha256_of_file(file);
}

void CorpusLabels::write(const std::string& recording, const Labels& labels) {
  make_folder(folder_);
  const auto file = file_of(recording);
  write_labels(file, labels);
  written_[file.filename().string()] = sha256_of_file(file);
  write_file(folder_ / kWritten, nlohmann::json(written_).dump(1) + "\n");
}

void CorpusLabels::write_text(const std::string& recording, std::span<const std::string> words) {
  make_folder(folder_);
  write_file(text_file_of(recording), fmt::format("{}\n", fmt::join(words, " ")));
}

std::string take_media(const std::filesystem::path& recording,
                       const std::filesystem::path& corpus) {
  namespace fs = std::filesystem;
  const auto within = fs::path{"media"} / recording.filename();
  const auto target = corpus / within;
  make_folder(target.parent_path());
  std::error_code failure;
  if (fs::exists(target, failure)) {
    if (fs::equivalent(recording, target, failure)) return within.string();
    if (sha256_of_file(recording) == sha256_of_file(target)) return within.string();
    throw Error{
        fmt::format("cannot take the recording '{}': the corpus has another '{}'; rename the "
                    "recording, or remove that file if it is out of date",
                    recording.string(),
                    target.string())};
  }
  fs::create_hard_link(fs::canonical(recording), target, failure);
  if (!failure) return within.string();
  fs::copy_file(recording, target, failure);
  if (!failure) return within.string();
  const auto reason = failure.message();
  fs::remove(target, failure);
  throw Error{
      fmt::format("cannot copy the recording '{}' to '{}': {}; check that the folder may be "
                  "written to and has room",
                  recording.string(),
                  target.string(),
                  reason)};
}

}  // namespace bimodal
