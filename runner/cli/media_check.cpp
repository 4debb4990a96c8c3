#include "runner/cli/media_check.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "runner/preparation/drawn_face.hpp"
#include "runner/preparation/shown_look.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/json_lines.hpp"
#include "stimuli/video/media_file.hpp"
#include "synth/speech/contact_check.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::runner {

namespace {

using protocols::Condition;

/// Containers round times to milliseconds, and the last frame's length may be a guess.
constexpr Duration kForgiven = std::chrono::milliseconds{50};

class MediaCheck {
 public:
  MediaCheck(const protocols::ReadProtocol& read, const std::string& file)
      : read_{read}, file_{file}, lines_{read.text} {}

  std::vector<Diagnostic> run() {
    const auto& conditions = read_.protocol.conditions;
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      pointer_ = read_.condition_pointers.at(i);
      check(conditions[i]);
    }
    return std::move(diagnostics_);
  }

 private:
  void check(const Condition& condition) {
    if (condition.auditory_talker) check_talker(*condition.auditory_talker, Need::Sound);
    const bool natural = condition.visual_talker && protocols::is_corpus(*condition.visual_talker);
    if (natural) check_talker(*condition.visual_talker, Need::Picture);
    const bool timed_apart = !condition.auditory_talker && condition.visual_talker && !natural;
    if (timed_apart) check_talker(condition.timing_talker, Need::Nothing);
    if (condition.visual_talker && !natural) {
      check_inventory(condition.articulating.segments);
      check_materials(condition.face.material);
    }
    if (condition.visual_talker) check_look(condition);
  }

  /// What it has wrong has its own file names and lines.
  void check_inventory(const std::string& file) {
    if (!told_.insert("inventory " + file).second) return;
    try {
      const auto table = synth::SegmentTable::parse(read_file(file), file, diagnostics_);
      if (table) check_contacts(*table, file);
    } catch (const Error& error) {
      find(error.what(), "name another inventory of segments");
    }
  }

  /// Of a preset, or of a file, which is judged as an inventory is.
  void check_materials(const std::string& material) {
    if (material.empty() || !told_.insert("materials " + material).second) return;
    try {
      const auto file = material_file(material);
      static_cast<void>(synth::Materials::parse(read_file(file), file.string(), diagnostics_));
    } catch (const Error& error) {
      find(error.what(), "name other materials");
    }
  }

  /// Lips that do not shut in some B are no mistake of the file, but nobody should miss it.
  void check_contacts(const synth::SegmentTable& table, const std::string& file) {
    constexpr std::array kRates{1.0};
    const auto report = synth::check_contacts(table, kRates);
    if (report.missed.empty()) return;
    const auto& first = report.missed.front();
    diagnostics_.push_back(
        {.severity = Severity::Warning,
         .file = file_,
         .line = lines_.line_of(pointer_),
         .pointer = pointer_,
         .finding =
             fmt::format("with the inventory '{}' the face does not shut its lips for P B M, or "
                         "touch its teeth for F V, long enough to be seen in {} of {} "
                         "syllables, e.g. {} in {}",
                         file,
                         report.missed.size(),
                         report.contexts,
                         symbol(first.phone),
                         first.context),
         .remedy = "see `bimodal segments check`"});
  }

  enum class Need { Nothing, Sound, Picture };

  void check_talker(const std::string& talker, Need need) {
    if (!protocols::is_corpus(talker)) return;
    const auto& corpus = read_.corpora.at(protocols::corpus_name(talker));
    for (const auto& item : needed(corpus)) check_item(corpus, *item, need);
  }

  /// The items that the protocol's words may ask for, each once.
  [[nodiscard]] std::set<const CorpusItem*> needed(const Corpus& corpus) const {
    std::set<const CorpusItem*> items;
    for (const auto* words : {&read_.practice, &read_.words.words}) {
      for (const auto& word : *words) {
        items.insert(find_item(corpus, word.spelling));
        if (word.seen) items.insert(find_item(corpus, word.seen->spelling));
      }
    }
    items.erase(nullptr);
    return items;
  }

  void check_item(const Corpus& corpus, const CorpusItem& item, Need need) {
    const auto* const media = examined(corpus, item.recording);
    if (media == nullptr) return;
    const auto place = media_file(corpus, item.recording).string();
    if (need == Need::Sound && !media->sound) {
      find_once(place,
                fmt::format("'{}' is to be heard and has no sound", place),
                "take another recording, or leave the condition out");
    }
    if (need == Need::Picture && !media->picture) {
      find_once(place,
                fmt::format("'{}' is to be seen and has no picture", place),
                "take a video of the talker, or leave the condition out");
    }
    if (item.end > media->length + kForgiven) {
      find_once(item.name,
                fmt::format("item \"{}\" ends at {:.3f} s, and '{}' at {:.3f} s",
                            item.name,
                            std::chrono::duration<double>{item.end}.count(),
                            place,
                            std::chrono::duration<double>{media->length}.count()),
                "build the corpus again");
    }
  }

  /// What a recording is; null, once told, if it cannot be used.
  const Media* examined(const Corpus& corpus, std::size_t recording) {
    const auto file = media_file(corpus, recording);
    const auto [found, is_new] = media_.try_emplace(file);
    if (!is_new) return found->second ? &*found->second : nullptr;
    try {
      if (sha256_of_file(file) != corpus.recordings.at(recording).sha256) {
        find_once(file,
                  fmt::format("'{}' is not the file that the corpus was made from", file.string()),
                  "put the original back, or build the corpus again");
        return nullptr;
      }
      found->second = examine_media(file);
      return &*found->second;
    } catch (const Error& error) {
      find_once(file, error.what(), "put the file there, or build the corpus again");
      return nullptr;
    }
  }

  void check_look(const Condition& condition) {
    if (has_errors(diagnostics_)) return;  // the look may be taken from what is wrong
    try {
      const auto& window = read_.protocol.window;
      const auto look = decide_look(condition, window, read_.corpora);
      double width = static_cast<double>(look.height) * 8.0 / 9.0;
      if (protocols::is_corpus(*condition.visual_talker)) {
        const auto& corpus = read_.corpora.at(protocols::corpus_name(*condition.visual_talker));
        width = 0.0;
        for (const auto& item : needed(corpus)) {
          const auto* const media = examined(corpus, item->recording);
          if (media == nullptr || !media->picture) continue;
          width = std::max(width,
                           static_cast<double>(look.height * media->picture->width) /
                               static_cast<double>(media->picture->height));
        }
      }
      if (std::lround(width) > window.width ||
          look.height > static_cast<std::size_t>(window.height)) {
        find(fmt::format("the picture, {:.0f} x {} pixels, does not fit into the window, {} x {}",
                         width,
                         look.height,
                         window.width,
                         window.height),
             "lower \"height\" of the look or /window/face_height, or enlarge the window");
      }
      check_patch(width, static_cast<double>(look.height));
    } catch (const Error& error) {
      find(error.what(), "mend \"look\"");
    }
  }

  /// Whether the patch for a photodiode hides a part of the picture, so many pixels in size.
  void check_patch(double width, double height) {
    const auto& photodiode = read_.protocol.triggers.photodiode;
    if (!photodiode) return;
    const auto& window = read_.protocol.window;
    const auto patch = protocols::patch_box(*photodiode, window.width, window.height);
    const auto lies_beside = [](double from, double size, int patch_from, int patch_size) {
      return patch_from >= from + size || patch_from + patch_size <= from;
    };
    if (lies_beside((window.width - width) / 2, width, patch.left, patch.width) ||
        lies_beside((window.height - height) / 2, height, patch.top, patch.height)) {
      return;
    }
    find("the patch for the photodiode (/triggers/photodiode) hides a part of the picture",
         "move it, make it smaller, or lower /window/face_height or \"height\" of the look",
         Severity::Warning);
  }

  void find(std::string finding, std::string remedy, Severity severity = Severity::Error) {
    diagnostics_.push_back({.severity = severity,
                            .file = file_,
                            .line = lines_.line_of(pointer_),
                            .pointer = pointer_,
                            .finding = std::move(finding),
                            .remedy = std::move(remedy)});
  }

  void find_once(const std::string& about, std::string finding, std::string remedy) {
    if (told_.insert(about + finding).second) find(std::move(finding), std::move(remedy));
  }

  const protocols::ReadProtocol& read_;
  std::string file_;
  JsonLines lines_;
  std::string pointer_;
  std::vector<Diagnostic> diagnostics_;
  std::map<std::filesystem::path, std::optional<Media>> media_;
  std::set<std::string> told_;
};

}  // namespace

std::vector<Diagnostic> check_media(const protocols::ReadProtocol& read, const std::string& file) {
  return MediaCheck{read, file}.run();
}

}  // namespace bimodal::runner
