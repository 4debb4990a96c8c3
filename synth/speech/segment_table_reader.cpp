#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/json_text.hpp"
#include "stimuli/base/located_reading.hpp"
#include "stimuli/timeline/inventory_file.hpp"
#include "synth/speech/segment_groups.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::synth {

namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 4> kKeys{"about", "extends", "sources", "groups"};
constexpr std::size_t kMostExtensions = 8;

}  // namespace

/// Reads one file, and before it what it extends.
class SegmentTableReader {
 public:
  /// `depth`: how many files extend this one.
  SegmentTableReader(std::string_view file, std::vector<Diagnostic>& diagnostics, std::size_t depth)
      : file_{file}, diagnostics_{diagnostics}, depth_{depth} {}

  std::optional<SegmentTable> read(std::string_view text) {
    auto table = read_located(
        text, file_, diagnostics_, kMostValues, [&](const json& root, Findings& findings) {
          findings_ = &findings;
          root_of(root);
          return std::move(table_);
        });
    if (table) table->sha256_ = sha256(std::string{text} + table->sha256_);
    return table;
  }

 private:
  const json* object_in(const json& parent, const char* key) {
    const auto found = parent.find(key);
    if (found != parent.end() && found->is_object()) return &*found;
    findings_->error("",
                     found == parent.end() ? fmt::format("\"{}\" is missing", key)
                                           : fmt::format("\"{}\" is not an object", key),
                     fmt::format("give an object \"{}\"", key));
    return nullptr;
  }

  void root_of(const json& root) {
    if (root.is_object() && (root.contains("definitions") || root.contains("segments"))) {
      findings_->error(
          "",
          "this is a score, or definitions for scores (`fit-segments` writes such), and "
          "no inventory of the face's segments",
          "measures are not controls: see synth/fitting/README.md, \"From measures to "
          "the face\"");
      return;
    }
    if (!root.is_object()) {
      findings_->error("", "is not an object", "give {\"sources\": ..., \"groups\": ...}");
      return;
    }
    for (const auto& [key, ignored] : root.items()) {
      if (std::ranges::find(kKeys, key) == kKeys.end()) {
        findings_->error("/" + escape_pointer(key),
                         "is not a known key",
                         fmt::format("known are: {}", fmt::join(kKeys, ", ")));
      }
    }
    const auto extended = root.find("extends");
    const bool extends = extended != root.end();
    if (extends) read_extended(*extended);
    if (!extends || root.contains("sources")) {
      if (const auto* sources = object_in(root, "sources")) read_sources(*sources);
    }
    SegmentGroups groups{table_.targets_, table_.sources_, *findings_};
    if (const auto* all = object_in(root, "groups")) {
      for (const auto& [name, group] : all->items()) {
        groups.read(group, "/groups/" + escape_pointer(name));
      }
    }
    for (const auto& key : own_sources_) {
      if (!groups.used_sources().contains(key)) {
        findings_->warning(
            "/sources/" + escape_pointer(key), "no row uses this source", "remove it");
      }
    }
    if (!extends) everything_set(groups.set());
  }

  /// Fills the table with that of another file, which stands beside this one or ships with the
  /// program.
  void read_extended(const json& name) {
    constexpr auto kPointer = "/extends";
    if (!name.is_string()) {
      findings_->error(
          kPointer, name.dump() + " is not the name of a file", "give e.g. \"english.json\"");
      return;
    }
    if (depth_ >= kMostExtensions) {
      findings_->error(kPointer,
                       fmt::format("more than {} files extend each other", kMostExtensions),
                       "does a file extend itself?");
      return;
    }
    const auto& written = name.get_ref<const std::string&>();
    try {
      const auto other = inventory_file(written, std::filesystem::path{file_}.parent_path());
      auto table =
          SegmentTableReader{other.string(), diagnostics_, depth_ + 1}.read(read_file(other));
      if (table) {
        table_ = *std::move(table);
        return;
      }
      findings_->error(
          kPointer, fmt::format("'{}' has mistakes", other.string()), "mend them first");
    } catch (const Error& error) {
      findings_->error(kPointer,
                       fmt::format("\"{}\" cannot be read: {}", written, error.what()),
                       "name a file beside this one, or one that ships: \"english.json\"");
    }
  }

  void read_sources(const json& sources) {
    for (const auto& [key, reference] : sources.items()) {
      const auto pointer = "/sources/" + escape_pointer(key);
      if (!reference.is_string() || reference.get_ref<const std::string&>().empty()) {
        findings_->error(pointer,
                         reference.dump() + " is not a reference",
                         "say in words where the values come from");
      } else if (!table_.sources_.emplace(key, reference.get<std::string>()).second) {
        findings_->error(pointer,
                         "the file that this one extends has a source of this name",
                         "give yours another name, or leave it out to use that one");
      } else {
        own_sources_.insert(key);
      }
    }
  }

  /// Nothing unknown becomes zero: each segment sets each speech control.
  void everything_set(const std::set<std::pair<Phone, Control>>& set) {
    // Groups that could not be read have been complained of; what they lack follows from that.
    const bool was_faulty = findings_->faulty("");
    for (const auto& control : controls().first<kSpeechControlCount>()) {
      std::vector<std::string_view> missing;
      for (const Phone phone : all_phones().first(kFaceSegmentCount)) {
        if (!set.contains({phone, control.control})) missing.push_back(symbol(phone));
      }
      if (missing.empty() || was_faulty) continue;
      if (missing.size() == kFaceSegmentCount) {
        findings_->error("/groups",
                         fmt::format("no group has the control {}", control.name),
                         "add it to a group's columns and rows");
      } else {
        findings_->error(
            "/groups",
            fmt::format("{} is not set for {}", control.name, fmt::join(missing, ", ")),
            "add rows for these segments");
      }
    }
  }

  std::string file_;
  std::vector<Diagnostic>& diagnostics_;
  std::size_t depth_;
  Findings* findings_ = nullptr;  // of the text that is being read
  SegmentTable table_;
  std::set<std::string> own_sources_;
};

std::optional<SegmentTable> SegmentTable::parse(std::string_view text,
                                                std::string_view file,
                                                std::vector<Diagnostic>& diagnostics) {
  return SegmentTableReader{file, diagnostics, 0}.read(text);
}

}  // namespace bimodal::synth
