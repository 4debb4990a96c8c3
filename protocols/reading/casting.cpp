#include "protocols/reading/casting.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/json_text.hpp"
#include "stimuli/timeline/inventory_file.hpp"

namespace bimodal::protocols {

namespace {

/// The folders in which a corpus is looked for, in this order.
std::vector<std::filesystem::path> places_of(const std::string& name,
                                             const std::filesystem::path& protocol_folder) {
  std::vector<std::filesystem::path> places{protocol_folder / name,
                                            protocol_folder / "corpora" / name,
                                            std::filesystem::path{"corpora"} / name};
  if (const char* folder = std::getenv("BIMODAL_CORPORA")) {
    places.push_back(std::filesystem::path{folder} / name);
  }
  if (const char* home = std::getenv("HOME")) {
    places.push_back(std::filesystem::path{home} / ".local/share/bimodal/corpora" / name);
  }
  return places;
}

/// Chooses and finds; see cast().
class Casting {
 public:
  Casting(const std::filesystem::path& folder, const CastOptions& options, Findings& findings)
      : folder_{folder}, options_{options}, findings_{findings} {}

  Cast run(const std::vector<WrittenCondition>& written) {
    judge_names(written);
    judge_wishes(written);
    judge_corpora(written);
    for (const auto& one : written) {
      if (takes_place(one.condition)) add(one);
    }
    if (cast_.conditions.empty() && !written.empty()) {
      findings_.error("/conditions", "no condition is left", "leave out fewer conditions");
    }
    return std::move(cast_);
  }

 private:
  void judge_names(const std::vector<WrittenCondition>& written) {
    std::map<std::string, std::size_t> index_of;
    for (std::size_t i = 0; i < written.size(); ++i) {
      const auto& name = written[i].condition.name;
      if (name.empty()) continue;  // it could not be read
      const auto [earlier, is_new] = index_of.emplace(name, i);
      if (is_new) continue;
      findings_.error(
          written[i].pointer + "/name",
          fmt::format("{} is already the name of condition {}", shown(name), earlier->second),
          "give each condition a name of its own; results are told apart by it");
    }
  }

  /// Corpora that are given and that no condition knows, even one that is left out.
  void judge_corpora(const std::vector<WrittenCondition>& written) {
    std::set<std::string> known;
    for (const auto& [condition, pointer, auditory, visual, timing] : written) {
      for (const auto& talker : {condition.auditory_talker.value_or(""),
                                 condition.visual_talker.value_or(""),
                                 condition.timing_talker,
                                 condition.look.like}) {
        if (is_corpus(talker)) known.insert(corpus_name(talker));
      }
    }
    const std::vector<std::string_view> names(known.begin(), known.end());
    for (const auto& [name, folder] : options_.corpora) {
      if (known.contains(name)) continue;
      findings_.error(
          "/conditions",
          fmt::format(
              "no talker is \"corpus:{}\", for which --corpus gives '{}'", name, folder.string()),
          known.empty() ? "the protocol uses no corpus" : suggestion(name, names));
    }
  }

  void judge_wishes(const std::vector<WrittenCondition>& written) {
    std::vector<std::string_view> names;
    for (const auto& one : written) names.push_back(one.condition.name);
    const auto judge = [&](const std::vector<std::string>& wishes, std::string_view option) {
      for (const auto& name : wishes) {
        if (std::ranges::find(names, name) != names.end()) continue;
        findings_.error("/conditions",
                        fmt::format("there is no condition {} for {}", shown(name), option),
                        suggestion(name, names));
      }
    };
    judge(options_.without, "--without");
    judge(options_.with, "--with");
  }

  [[nodiscard]] bool takes_place(const Condition& condition) const {
    const auto named = [&](const std::vector<std::string>& names) {
      return std::ranges::find(names, condition.name) != names.end();
    };
    if (named(options_.without)) return false;
    return !condition.optional || named(options_.with);
  }

  void add(const WrittenCondition& written) {
    auto condition = written.condition;
    const auto find_talker =
        [&](std::string& talker, const std::string& otherwise, const char* key) {
          if (!is_corpus(talker) || find_corpus(corpus_name(talker))) return;
          replace(talker, otherwise, written, key);
        };
    if (condition.auditory_talker) {
      find_talker(*condition.auditory_talker, written.auditory_otherwise, "/auditory/talker");
    }
    if (condition.visual_talker) {
      find_talker(*condition.visual_talker, written.visual_otherwise, "/visual/talker");
    }
    if (condition.auditory_talker) {
      condition.timing_talker = *condition.auditory_talker;
    } else if (condition.visual_talker && is_corpus(*condition.visual_talker)) {
      condition.timing_talker = *condition.visual_talker;
    } else if (!written.condition.visual_talker || !is_corpus(*written.condition.visual_talker)) {
      find_talker(condition.timing_talker, written.timing_otherwise, "/timing/talker");
    } else {
      condition.timing_talker = Condition{}.timing_talker;
    }
    if (is_corpus(condition.look.like) && !find_corpus(corpus_name(condition.look.like))) {
      replace(condition.look.like, "", written, "/visual/look/like");
    }
    const bool has_face = condition.visual_talker && !is_corpus(*condition.visual_talker);
    if (has_face) find_inventory(condition.articulating, written);
    cast_.conditions.push_back(std::move(condition));
    cast_.pointers.push_back(written.pointer);
  }

  void find_inventory(Articulating& articulating, const WrittenCondition& written) {
    try {
      articulating.segments = inventory_file(articulating.segments, folder_).string();
    } catch (const Error& error) {
      findings_.error(written.pointer + "/visual/segments",
                      error.what(),
                      "it is a path relative to the protocol, or the name of an inventory");
    }
  }

  void replace(std::string& talker,
               const std::string& otherwise,
               const WrittenCondition& written,
               const char* key) {
    const auto name = corpus_name(talker);
    const auto pointer = written.pointer + key;
    if (broken_.contains(name)) {
      if (!told_broken_.insert(name).second) return;
      findings_.error(pointer,
                      fmt::format("the corpus {} cannot be used", shown(name)),
                      "what is wrong with it is listed first");
    } else if (!otherwise.empty()) {
      findings_.warning(
          pointer,
          fmt::format("there is no corpus {}; {} takes its place", shown(name), shown(otherwise)),
          fmt::format("that is stored with every trial; for a talker of your own give --corpus "
                      "{}=FOLDER",
                      name));
      talker = otherwise;
    } else {
      findings_.error(
          pointer,
          fmt::format(
              "there is no corpus {} for condition {}", shown(name), shown(written.condition.name)),
          fmt::format("make one with `bimodal corpus build`, then give --corpus {}=FOLDER (or put "
                      "it into {}), or leave the condition out: --without {}",
                      name,
                      places_of(name, folder_)[1].string(),
                      written.condition.name));
    }
  }

  bool find_corpus(const std::string& name) {
    if (cast_.corpora.contains(name)) return true;
    if (missing_.contains(name) || broken_.contains(name)) return false;
    const auto given = options_.corpora.find(name);
    if (given != options_.corpora.end()) return read(name, given->second);
    for (const auto& place : places_of(name, folder_)) {
      std::error_code ignored;
      if (std::filesystem::exists(place / kManifestName, ignored)) return read(name, place);
    }
    missing_.insert(name);
    return false;
  }

  bool read(const std::string& name, const std::filesystem::path& place) {
    std::vector<Diagnostic> found;
    auto corpus = read_corpus(place, found);
    cast_.corpus_findings.insert(cast_.corpus_findings.end(), found.begin(), found.end());
    if (has_errors(found)) {
      broken_.insert(name);
      return false;
    }
    cast_.corpora.emplace(name, std::move(corpus));
    return true;
  }

  const std::filesystem::path& folder_;
  const CastOptions& options_;
  Findings& findings_;
  Cast cast_;
  std::set<std::string> missing_;
  std::set<std::string> broken_;
  std::set<std::string> told_broken_;
};

}  // namespace

Cast cast(const std::vector<WrittenCondition>& written,
          const std::filesystem::path& protocol_folder,
          const CastOptions& options,
          Findings& findings) {
  return Casting{protocol_folder, options, findings}.run(written);
}

}  // namespace bimodal::protocols
