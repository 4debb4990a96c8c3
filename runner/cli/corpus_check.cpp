#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "runner/cli/corpus_verbs.hpp"
#include "runner/cli/text_table.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/csv.hpp"
#include "stimuli/base/milliseconds.hpp"
#include "stimuli/corpus/check_corpus.hpp"

namespace bimodal::runner {

namespace {

using Json = nlohmann::ordered_json;

struct CheckOptions {
  std::string corpus;
  std::string words;
  bool csv = false;
  bool json = false;
};

/// A level, or nothing where there is none.
std::string level_text(double level) {
  return std::isfinite(level) ? fmt::format("{:.1f}", level) : std::string{};
}

Json level_json(double level) {
  return std::isfinite(level) ? Json(level) : Json(nullptr);
}

double relative(const ItemSound& sound, Decibels margin) {
  return margin.count() - sound.speech.count();
}

void print_recording(const Recording& recording, const RecordingCheck& check) {
  fmt::print("{}  talker {}{}\n",
             recording.file,
             recording.talker,
             recording.licence.empty() ? ", no licence given" : ", " + recording.licence);
  if (check.media) {
    const auto& [container, length, picture, sound] = *check.media;
    fmt::print("  {:.2f} s", milliseconds(length) / 1000.0);
    if (picture) {
      fmt::print("; picture {}x{} {}, {:.3f} frames/s{}{}",
                 picture->width,
                 picture->height,
                 picture->codec,
                 picture->frame_rate.count(),
                 picture->variable_rate ? " (variable)" : "",
                 picture->interlaced ? ", interlaced" : "");
    }
    if (sound) {
      fmt::print("; sound {} Hz {}, {}",
                 sound->rate.count(),
                 sound->codec,
                 counted(static_cast<std::size_t>(sound->channels), "channel"));
    }
    fmt::print("\n");
  }
  if (check.sound_begins_later && check.sound_ends_later) {
    fmt::print(
        "  sound after picture: {:+.0f} ms at the beginning, {:+.0f} ms at the end, by the "
        "file's time stamps\n  (not measured from what is seen and heard)\n",
        milliseconds(*check.sound_begins_later),
        milliseconds(*check.sound_ends_later));
  }
  for (const auto& finding : check.findings) fmt::print("  look: {}\n", finding);
  for (const auto& error : check.errors) fmt::print("  error: {}\n", error);
}

void print_items(const Corpus& corpus, const CorpusCheck& check) {
  std::vector<std::vector<std::string>> rows{
      {"item", "dB FS", "before ms, dB", "after ms, dB", "clipped", "frames", "to look at"}};
  for (std::size_t i = 0; i < corpus.items.size(); ++i) {
    const auto& item = check.items[i];
    auto notes = item.errors;
    for (auto& note : notes) note = "ERROR " + note;
    notes.insert(notes.end(), item.findings.begin(), item.findings.end());
    const auto margin = [&](Duration length, Decibels ItemSound::*level) {
      return fmt::format("{:.0f} {:>6}",
                         milliseconds(length),
                         item.sound ? level_text(relative(*item.sound, *item.sound.*level)) : "");
    };
    rows.push_back({corpus.items[i].name,
                    item.sound ? level_text(item.sound->speech.count()) : "",
                    margin(item.before, &ItemSound::before),
                    margin(item.after, &ItemSound::after),
                    item.sound ? std::to_string(item.sound->clipped) : "",
                    item.frames ? std::to_string(item.frames->count) : "",
                    fmt::format("{}", fmt::join(notes, "; "))});
  }
  print_text_table(rows, "lrrrrrl");
}

void print_table(const Corpus& corpus, const CorpusCheck& check) {
  fmt::print("{}: {}, {}\n\n",
             corpus.name,
             counted(corpus.recordings.size(), "recording"),
             counted(corpus.items.size(), "item"));
  for (std::size_t i = 0; i < corpus.recordings.size(); ++i) {
    print_recording(corpus.recordings[i], check.recordings[i]);
  }
  fmt::print("\n");
  print_items(corpus, check);
  fmt::print("\n");
  if (check.median_level) {
    fmt::print("speech level: median {:.1f} dB FS{}\n",
               check.median_level->count(),
               check.level_sd_db ? fmt::format(", SD {:.1f} dB", *check.level_sd_db) : "");
  }
  if (!check.doubled.empty()) {
    fmt::print("words with several items (the first is used): {}\n",
               fmt::join(check.doubled, ", "));
  }
  if (!check.missing.empty()) {
    fmt::print("words of the list without a usable item: {}\n", fmt::join(check.missing, ", "));
  }
  fmt::print("{}, {}\n",
             counted(check.findings(), "thing") + " to look at",
             counted(check.errors(), "error"));
}

void print_csv(const Corpus& corpus, const CorpusCheck& check) {
  fmt::print(
      "item,word,recording,level_dbfs,before_ms,before_db,after_ms,after_db,clipped,frames,"
      "uneven_frames,doubled_frames,findings,errors\n");
  for (std::size_t i = 0; i < corpus.items.size(); ++i) {
    const auto& item = corpus.items[i];
    const auto& [sound, before, after, frames, findings, errors] = check.items[i];
    fmt::print("{},{},{},{},{:.1f},{},{:.1f},{},{},{},{},{},{},{}\n",
               csv_field(item.name),
               csv_field(item.word),
               csv_field(corpus.recordings[item.recording].file),
               sound ? level_text(sound->speech.count()) : "",
               milliseconds(before),
               sound ? level_text(relative(*sound, sound->before)) : "",
               milliseconds(after),
               sound ? level_text(relative(*sound, sound->after)) : "",
               sound ? std::to_string(sound->clipped) : "",
               frames ? std::to_string(frames->count) : "",
               frames ? std::to_string(frames->uneven) : "",
               frames ? std::to_string(frames->doubled) : "",
               csv_field(fmt::format("{}", fmt::join(findings, "; "))),
               csv_field(fmt::format("{}", fmt::join(errors, "; "))));
  }
}

Json as_json(const Recording& recording, const RecordingCheck& check) {
  Json json{{"file", recording.file}, {"talker", recording.talker}, {"licence", recording.licence}};
  if (check.media && check.media->picture) {
    const auto& picture = *check.media->picture;
    json["picture"] = {{"width", picture.width},
                       {"height", picture.height},
                       {"frame_rate_hz", picture.frame_rate.count()},
                       {"variable_rate", picture.variable_rate},
                       {"interlaced", picture.interlaced},
                       {"codec", picture.codec}};
  }
  if (check.media && check.media->sound) {
    const auto& sound = *check.media->sound;
    json["sound"] = {
        {"rate_hz", sound.rate.count()}, {"channels", sound.channels}, {"codec", sound.codec}};
  }
  if (check.sound_begins_later && check.sound_ends_later) {
    json["sync"] = {{"sound_begins_later_ms", milliseconds(*check.sound_begins_later)},
                    {"sound_ends_later_ms", milliseconds(*check.sound_ends_later)},
                    {"source", "time stamps of the file; not measured from the content"}};
  }
  json["findings"] = check.findings;
  json["errors"] = check.errors;
  return json;
}

Json as_json(const CorpusItem& item, const ItemCheck& check) {
  Json json{{"item", item.name},
            {"word", item.word},
            {"before_ms", milliseconds(check.before)},
            {"after_ms", milliseconds(check.after)}};
  if (check.sound) {
    json["level_dbfs"] = level_json(check.sound->speech.count());
    json["before_db"] = level_json(relative(*check.sound, check.sound->before));
    json["after_db"] = level_json(relative(*check.sound, check.sound->after));
    json["clipped"] = check.sound->clipped;
  }
  if (check.frames) {
    json["frames"] = check.frames->count;
    json["uneven_frames"] = check.frames->uneven;
    json["doubled_frames"] = check.frames->doubled;
  }
  json["findings"] = check.findings;
  json["errors"] = check.errors;
  return json;
}

void print_json(const Corpus& corpus, const CorpusCheck& check) {
  Json json{{"corpus", corpus.name}, {"sha256", corpus.sha256}};
  json["recordings"] = Json::array();
  for (std::size_t i = 0; i < corpus.recordings.size(); ++i) {
    json["recordings"].push_back(as_json(corpus.recordings[i], check.recordings[i]));
  }
  json["items"] = Json::array();
  for (std::size_t i = 0; i < corpus.items.size(); ++i) {
    json["items"].push_back(as_json(corpus.items[i], check.items[i]));
  }
  if (check.median_level) json["median_level_dbfs"] = check.median_level->count();
  if (check.level_sd_db) json["level_sd_db"] = *check.level_sd_db;
  json["missing"] = check.missing;
  json["doubled"] = check.doubled;
  fmt::print("{}\n", json.dump(2));
}

ExitCode check(const CheckOptions& options) {
  const auto corpus = open_corpus(options.corpus);
  const auto list = options.words.empty() ? WordList{} : words_named(options.words);
  const auto found = check_corpus(corpus, list.words, progress_on_terminal());
  if (options.csv) {
    print_csv(corpus, found);
  } else if (options.json) {
    print_json(corpus, found);
  } else {
    print_table(corpus, found);
  }
  if (found.errors() > 0) return ExitCode::InvalidInput;
  return found.findings() > 0 ? ExitCode::Findings : ExitCode::Done;
}

}  // namespace

void add_corpus_check(CLI::App& corpus, Verb& chosen) {
  auto* const verb = corpus.add_subcommand(
      "check",
      "Looks at everything in a corpus: files there and unchanged, every item decodable; levels,\n"
      "clipping, margins and what sounds in them, frame rate, dropped and doubled frames, sync as "
      "far\n"
      "as the file tells it, missing, doubled and doubtful items.\n"
      "Exit code: 0 clean, 1 something to look at, 3 errors.\n\n"
      "Examples:\n"
      "  bimodal corpus check anna\n"
      "  bimodal corpus check anna --words monosyllables-414      is the list complete?\n"
      "  bimodal corpus check anna --csv > anna-check.csv");
  auto options = std::make_shared<CheckOptions>();
  verb->add_option("CORPUS", options->corpus, "a folder with corpus.json")->required();
  verb->add_option("--words", options->words, "which words should be there (see corpus build)");
  auto* const csv =
      verb->add_flag("--csv", options->csv, "items as a table for programs (RFC 4180)");
  verb->add_flag("--json", options->json, "everything, for programs")->excludes(csv);
  verb->callback([options, &chosen] { chosen = [options] { return check(*options); }; });
}

}  // namespace bimodal::runner
