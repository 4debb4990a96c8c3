#include <array>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "runner/cli/option_checks.hpp"
#include "runner/cli/reading_strips.hpp"
#include "runner/cli/sheet_painter.hpp"
#include "runner/cli/verbs.hpp"
#include "synth/speech/durations.hpp"

namespace bimodal::runner {

namespace {

struct SheetsOptions {
  std::string sheet;
  std::string output;
  std::string segments = "english";
  int height = 180;
  std::uint64_t seed = 1;
};

std::vector<TimedSegment> around(Phone phone) {
  if (is_vowel(phone)) return synth::timed(std::array<Segment, 1>{phone});
  return synth::timed(std::array<Segment, 3>{Phone::AA, phone, Phone::AA});
}

/// Every segment: consonants between /a/, vowels alone; from the front and from the side.
std::vector<SheetRow> segment_rows(SheetPainter& painter) {
  constexpr std::size_t kInARow = 6;
  std::vector<SheetRow> rows;
  std::size_t in_row = kInARow;
  for (const Phone phone : all_phones()) {
    if (phone == Phone::Rest) continue;
    if (in_row == kInARow) {
      rows.emplace_back();
      in_row = 0;
    }
    const auto segments = around(phone);
    const auto articulation = painter.articulation(segments);
    const auto& shown = segments[segments.size() / 2];
    const auto name = std::string{symbol(phone)};
    rows.back().cells.push_back(painter.front(articulation, shown.centre(), name));
    rows.back().cells.push_back(painter.side(articulation, shown.centre(), ""));
    ++in_row;
  }
  return rows;
}

/// "stew" each 20 ms, with and without coarticulation.
std::vector<SheetRow> coarticulation_rows(SheetPainter& painter) {
  constexpr Milliseconds kStep{20};
  constexpr Milliseconds kBefore{60};
  const auto segments = synth::typed_segments("S:140 T:60 UW1:200");
  const std::array accounts{std::pair{Account::Dominance, "with coarticulation (dominance)"},
                            std::pair{Account::Interpolation, "without coarticulation (none)"}};
  std::vector<SheetRow> rows;
  for (const auto& [account, title] : accounts) {
    const auto articulation = painter.articulation(segments, account);
    SheetRow row{.title = fmt::format("\"stew\", each 20 ms, {}", title), .cells = {}};
    const auto first = segments[1].start - kBefore;
    for (auto time = first; time < segments[3].end(); time += kStep) {
      std::string said = "-";
      for (const auto& one : segments) {
        if (one.start <= time && time < one.end()) said = std::string{symbol(one.segment)};
      }
      row.cells.push_back(painter.front(
          articulation, time, fmt::format("{:.0f} {}", (time - segments[1].start).count(), said)));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<SheetRow> continuum_rows(SheetPainter& painter) {
  constexpr int kSteps = 8;
  std::vector<SheetRow> rows{
      {.title = "B to W before AA: middle of the sound, and 30 ms after it", .cells = {}},
      {.title = "", .cells = {}}};
  for (int step = 0; step <= kSteps; ++step) {
    const auto segments = synth::typed_segments(fmt::format("B~W:{}/{} AA", step, kSteps));
    const auto articulation = painter.articulation(segments);
    const auto name = fmt::format("{}/{}", step, kSteps);
    rows[0].cells.push_back(painter.front(articulation, segments[1].centre(), ""));
    rows[1].cells.push_back(
        painter.front(articulation, segments[1].end() + Milliseconds{30}, name));
  }
  return rows;
}

std::vector<SheetRow> rate_rows(SheetPainter& painter) {
  std::vector<SheetRow> rows;
  for (const double rate : {0.5, 1.0, 2.0}) {
    const auto segments = synth::at_rate(synth::typed_segments("S P UW N F UH L TH IY V"), rate);
    const auto articulation = painter.articulation(segments);
    SheetRow row{.title = fmt::format("\"spoonful thieve\" at rate {:g}", rate), .cells = {}};
    for (const auto& one : segments) {
      if (one.segment.from == Phone::Rest) continue;
      row.cells.push_back(
          painter.front(articulation, one.centre(), std::string{symbol(one.segment)}));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

ExitCode sheets(const SheetsOptions& options) {
  SheetPainter painter{options.segments, options.height};
  if (options.sheet == "reading") {
    const auto strips = write_reading_strips(painter, options.seed, options.output);
    fmt::print("{}: {} strips and key.csv; show the strips without it\n", options.output, strips);
    return ExitCode::Done;
  }
  const auto rows = options.sheet == "segments"         ? segment_rows(painter)
                    : options.sheet == "coarticulation" ? coarticulation_rows(painter)
                    : options.sheet == "continuum"      ? continuum_rows(painter)
                                                        : rate_rows(painter);
  const auto sheet = contact_sheet(rows);
  write_png(sheet, options.output);
  fmt::print("{}: {} x {} pixels\n", options.output, sheet.width, sheet.height);
  return ExitCode::Done;
}

}  // namespace

void add_sheets(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "sheets",
      "Draws contact sheets of the face's mouth, for documentation and for judging it:\n"
      "  segments          every segment from the front and from the side: consonants between /a/\n"
      "  coarticulation    \"stew\" each 20 ms, with and without coarticulation\n"
      "  continuum         from B to W in nine steps\n"
      "  rates             every segment of a phrase at three rates\n"
      "  reading           a folder of 36 unlabelled strips, VCV of 12 consonants and 3 vowels in\n"
      "                    shuffled order, and key.csv: to see whether somebody can read them\n\n"
      "Examples:\n"
      "  bimodal sheets segments -o segments.png\n"
      "  bimodal sheets reading --seed 7 -o strips");
  auto options = std::make_shared<SheetsOptions>();
  verb->add_option("SHEET", options->sheet, "which one")
      ->required()
      ->check(CLI::IsMember({"segments", "coarticulation", "continuum", "rates", "reading"}));
  verb->add_option("-o,--output", options->output, "PNG file; of reading, a folder")
      ->required()
      ->check(in_a_folder_that_exists());
  verb->add_option("--segments", options->segments, "inventory: a file, or english (default)");
  verb->add_option("--height", options->height, "of each picture in pixels (180)")
      ->check(CLI::Range(64, 1024));
  verb->add_option("--seed", options->seed, "of the order of reading (1)");
  verb->callback([options, &chosen] { chosen = [options] { return sheets(*options); }; });
}

}  // namespace bimodal::runner
