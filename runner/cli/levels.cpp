#include <algorithm>
#include <charconv>
#include <ctime>
#include <memory>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "runner/calibration/level_table.hpp"
#include "runner/cli/levels_verbs.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/devices/device_error.hpp"
#include "runner/devices/portaudio/output_name.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

struct SetOptions {
  LevelOptions level;
  double dbspl = 0;
  std::string instrument;
  std::string note;
};

std::optional<double> number_from(std::string_view text) {
  double number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// The name by which a device is known again. One that is not here now is taken as it is given.
std::string name_of(const std::string& device) {
  if (device == "none") return device;
  try {
    return output_name(device);
  } catch (const DeviceError&) {
    if (device.empty()) throw;
    fmt::print("no sound output '{}' is here now: kept under this very name\n", device);
    return device;
  }
}

std::string row_of(const MeasuredLevel& level) {
  const auto what = level.low_hz == level.high_hz
                        ? fmt::format("tone {:g} Hz", level.low_hz)
                        : fmt::format("noise {:g}-{:g} Hz", level.low_hz, level.high_hz);
  return fmt::format("{:<20} {:>6} /s  {:<10} {:>6.1f} dB FS = {:>6.1f} dB SPL  {}{}{}",
                     what,
                     level.rate_hz,
                     level.channel ? fmt::format("channel {}", *level.channel) : "both ears",
                     level.dbfs.count(),
                     level.dbspl.count(),
                     level.date,
                     level.instrument.empty() ? "" : ", " + level.instrument,
                     level.note.empty() ? "" : ", " + level.note);
}

ExitCode list() {
  const auto file = level_file();
  const auto table = read_levels(file);
  if (table.levels().empty()) {
    fmt::print("no level has been measured yet ({}); see `bimodal levels play --help`\n",
               file.string());
    return ExitCode::Findings;
  }
  auto levels = table.levels();
  std::ranges::stable_sort(levels, {}, &MeasuredLevel::device);
  const std::string* device = nullptr;
  for (const auto& level : levels) {
    if (device == nullptr || *device != level.device) fmt::print("{}\n", level.device);
    device = &level.device;
    fmt::print("  {}\n", row_of(level));
  }
  return ExitCode::Done;
}

ExitCode set(const SetOptions& options) {
  const auto content = content_of(options.level);
  const auto* const band = std::get_if<Band>(&content);
  MeasuredLevel level{.device = name_of(options.level.device),
                      .rate_hz = options.level.rate_hz,
                      .low_hz = band != nullptr ? band->low.count() : *options.level.tone_hz,
                      .high_hz = band != nullptr ? band->high.count() : *options.level.tone_hz,
                      .channel = options.level.channel,
                      .dbfs = Decibels{options.level.dbfs},
                      .dbspl = DecibelsSpl{options.dbspl},
                      .date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr))),
                      .instrument = options.instrument,
                      .note = options.note};
  const auto file = level_file();
  auto table = read_levels(file);
  const auto earlier = table.put(level);
  write_levels(file, table);
  fmt::print("{}\n  {}\n", level.device, row_of(level));
  if (earlier) fmt::print("in place of\n  {}\n", row_of(*earlier));
  fmt::print("kept in {}\n", file.string());
  return ExitCode::Done;
}

}  // namespace

void add_level_options(CLI::App& verb, LevelOptions& options) {
  verb.add_option(
      "--device", options.device, "a name or number (see `bimodal devices`); the default one");
  auto* const band = verb.add_option("--band", options.band, "of the noise, in Hz (80-8000)");
  verb.add_option("--tone", options.tone_hz, "a tone of this frequency in Hz instead")
      ->check(finite_number())
      ->check(CLI::Range(1.0, 96'000.0))
      ->excludes(band);
  verb.add_option("--dbfs", options.dbfs, "its level (RMS) in dB re full scale (-30)")
      ->check(finite_number())
      ->check(CLI::Range(-120.0, 0.0));
  verb.add_option("--rate", options.rate_hz, "samples per second (48000)")
      ->check(CLI::Range(8'000, 192'000));
  verb.add_option("--channel", options.channel, "only this one, from 1 (both ears)")
      ->check(CLI::Range(1, 32));
}

std::variant<Band, Hertz> content_of(const LevelOptions& options) {
  if (options.tone_hz) return Hertz{*options.tone_hz};
  const std::string_view text = options.band;
  const auto dash = text.find('-');
  const auto low = number_from(text.substr(0, dash));
  const auto high =
      dash == std::string_view::npos ? std::nullopt : number_from(text.substr(dash + 1));
  if (!low || !high || *low < 1 || *low >= *high) {
    throw Error{
        fmt::format("'{}' is not a band; give its edges in Hz, e.g. --band 80-8000", options.band)};
  }
  return Band{.low = Hertz{*low}, .high = Hertz{*high}};
}

std::string describe(const LevelOptions& options) {
  const auto what = options.tone_hz ? fmt::format("a tone of {:g} Hz", *options.tone_hz)
                                    : fmt::format("noise of {} Hz", options.band);
  return fmt::format("{} at {:g} dB FS on {}",
                     what,
                     options.dbfs,
                     options.channel ? fmt::format("channel {}", *options.channel) : "both ears");
}

void add_levels(CLI::App& app, Verb& chosen) {
  auto* const levels = app.add_subcommand(
      "levels",
      "Which sound pressure a level re full scale has at the ear, as measured on each sound "
      "output:\nwhat protocols need that ask for dB SPL. It holds for the same band, and as long "
      "as no knob is\nturned and nothing is exchanged on the way to the ear.");
  levels->require_subcommand(1);
  add_levels_play(*levels, chosen);
  auto* const set_verb = levels->add_subcommand(
      "set",
      "Keeps what was measured while `levels play` played with the same options.\n\n"
      "Example:\n"
      "  bimodal levels set --dbfs -30 --band 80-8000 --dbspl 65.2 --instrument 'B&K 2250, 4153'");
  auto options = std::make_shared<SetOptions>();
  add_level_options(*set_verb, options->level);
  set_verb->add_option("--dbspl", options->dbspl, "the level that was measured, dB SPL")
      ->required()
      ->check(finite_number())
      ->check(CLI::Range(-20.0, 160.0));
  set_verb->add_option("--instrument", options->instrument, "what it was measured with");
  set_verb->add_option("--note", options->note, "what else should be known: headphones, knobs");
  set_verb->callback([options, &chosen] { chosen = [options] { return set(*options); }; });
  auto* const list_verb = levels->add_subcommand("list", "What has been measured.");
  list_verb->callback([&chosen] { chosen = list; });
}

}  // namespace bimodal::runner
