#include "runner/cli/stimuli_strip.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runner/cli/media_check.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/cli/protocol_file.hpp"
#include "runner/preparation/face_quality.hpp"
#include "runner/preparation/trial_preparer.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/milliseconds.hpp"
#include "stimuli/picture/drawing.hpp"
#include "stimuli/picture/image.hpp"
#include "stimuli/picture/resize.hpp"

namespace bimodal::runner {

namespace {

struct StripOptions {
  ProtocolChoice protocol;
  std::string word;
  std::vector<std::string> conditions;
  std::string output;
  std::string frames;
  double rate_hz = 60.0;
  int height = 360;
};

/// By its whole name ("ba seen as da"), else the only one that is heard, or seen, so.
const Word& find_word(const protocols::ReadProtocol& read, const std::string& spelling) {
  std::vector<const Word*> found;
  for (const auto* words : {&read.words.words, &read.practice}) {
    for (const auto& word : *words) {
      if (shown_name(word) == spelling) return word;
      const bool is_seen = word.seen && word.seen->spelling == spelling;
      if (word.spelling == spelling || is_seen) found.push_back(&word);
    }
  }
  if (found.size() == 1) return *found.front();
  if (found.empty()) throw Error{fmt::format("the protocol has no word \"{}\"", spelling)};
  std::vector<std::string> names;
  for (const auto* word : found) names.push_back(shown_name(*word));
  throw Error{fmt::format(
      "several words are called \"{}\"; say which: {}", spelling, fmt::join(names, ", "))};
}

/// The conditions that are asked for, else all in which somebody is seen.
std::vector<std::size_t> find_conditions(const protocols::ReadProtocol& read,
                                         const std::vector<std::string>& names) {
  const auto& conditions = read.protocol.conditions;
  std::vector<std::size_t> found;
  for (const auto& name : names) {
    const auto at = std::ranges::find(conditions, name, &protocols::Condition::name);
    if (at == conditions.end()) {
      throw Error{fmt::format(
          "the protocol has no condition \"{}\" (--with takes optional ones in)", name)};
    }
    found.push_back(static_cast<std::size_t>(at - conditions.begin()));
  }
  for (std::size_t i = 0; names.empty() && i < conditions.size(); ++i) {
    if (conditions[i].visual_talker) found.push_back(i);
  }
  for (const auto i : found) {
    if (!conditions[i].visual_talker) {
      throw Error{fmt::format("in condition \"{}\" nobody is seen", conditions[i].name)};
    }
  }
  if (found.empty()) throw Error{"the protocol shows nobody"};
  return found;
}

Colour colour_of(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16U),
          static_cast<std::uint8_t>(rgb >> 8U),
          static_cast<std::uint8_t>(rgb)};
}

constexpr std::size_t kCaptionHeight = 24;  ///< pixels
constexpr std::size_t kWideCell = 300;      ///< pixels: has room for captions at double scale
constexpr Colour kInk{235, 235, 235};

/// A picture with `image` in its middle, cut or surrounded as need be.
Image make_cell(const Image* image, std::size_t width, std::size_t height, Colour ground) {
  auto cell = blank_image(width, height, ground);
  if (image == nullptr) return cell;
  const auto offset = [](std::size_t room, std::size_t size) {
    return (static_cast<std::int64_t>(room) - static_cast<std::int64_t>(size)) / 2;
  };
  paste(cell, {offset(width, image->width), offset(height, image->height)}, *image);
  return cell;
}

/// The frame of a film that is shown at an instant of the recording.
std::size_t frame_shown_at(const StimulusLayout& layout, Hertz rate, Duration time) {
  const auto frame =
      lead_frames(layout, rate) +
      static_cast<std::int64_t>(std::chrono::duration<double>{time}.count() * rate.count());
  return static_cast<std::size_t>(
      std::clamp<std::int64_t>(frame, 0, frame_count(layout, rate) - 1));
}

class StripMaker {
 public:
  StripMaker(const protocols::ReadProtocol& read, const StripOptions& options)
      : read_{read},
        options_{options},
        repertoire_{read.protocol.sound.rate, read.corpora},
        studio_{read.protocol.window,
                read.corpora,
                choose_quality(read.protocol.window.face_quality, std::nullopt).quality} {}

  void add(std::size_t index, const Word& word) {
    const auto& condition = read_.protocol.conditions[index];
    const Hertz rate{options_.rate_hz};
    const auto enactment = enact(condition, word, repertoire_);
    const StimulusLayout layout{.recording = enactment.length,
                                .lead = {},
                                .trail = {},
                                .sound_lead = {},
                                .sound_trail = {},
                                .av_offset = {},
                                .has_sound = false};
    const auto film = studio_.film(condition, enactment, layout, rate, [] {});
    if (!options_.frames.empty()) write_frames(condition.name, film);
    fmt::print("{}: {} of {} pictures at {:g} Hz\n",
               condition.name,
               film.pictures.size(),
               film.picture_of_frame.size(),
               rate.count());
    Row row{.condition = condition.name, .pictures = {}, .captions = {}};
    const bool is_face = !enactment.articulation.empty();
    for (std::size_t i = 0; i < enactment.seen.phones.size(); ++i) {
      const auto& timed = enactment.seen.phones[i];
      const auto segment = is_face ? enactment.articulation[i].segment : Segment{timed.phone};
      const auto centre = timed.start + timed.duration / 2;
      const auto number = film.picture_of_frame[frame_shown_at(layout, rate, centre)];
      const auto source = number != Film::kBlank && !film.source_frame_of_picture.empty()
                              ? fmt::format("  frame {}", film.source_frame_of_picture[number])
                              : std::string{};
      const auto ms = milliseconds(centre);
      fmt::print("  {:<5} {:>7.1f} ms{}\n", symbol(segment), ms, source);
      row.pictures.push_back(scaled_picture(film, number));
      row.captions.push_back(fmt::format("{} {:.0f} ms{}", symbol(segment), ms, source));
    }
    rows_.push_back(std::move(row));
  }

  void write() const {
    if (options_.output.empty()) return;
    std::size_t columns = 0;
    // As wide and high as the largest picture, so that none is cropped.
    Size cell{.width = least_height() * 8 / 9, .height = least_height()};
    for (const auto& row : rows_) {
      columns = std::max(columns, row.pictures.size());
      for (const auto& picture : row.pictures) {
        if (!picture) continue;
        cell.width = std::max(cell.width, picture->width);
        cell.height = std::max(cell.height, picture->height);
      }
    }
    // Above each row the condition's name, below each picture what it shows.
    const auto line = cell.height + 2 * kCaptionHeight;
    const std::int64_t scale = cell.width < kWideCell ? 1 : 2;
    const auto ground = colour_of(read_.protocol.window.background);
    auto sheet = blank_image(columns * cell.width, rows_.size() * line, {24, 24, 24});
    for (std::size_t y = 0; y < rows_.size(); ++y) {
      const auto top = static_cast<std::int64_t>(y * line);
      const auto pictures = top + static_cast<std::int64_t>(kCaptionHeight);
      const auto below = pictures + static_cast<std::int64_t>(cell.height);
      draw_text(sheet, {4, top + 4}, rows_[y].condition, kInk, 2);
      for (std::size_t x = 0; x < rows_[y].pictures.size(); ++x) {
        const auto left = static_cast<std::int64_t>(x * cell.width);
        const auto& picture = rows_[y].pictures[x];
        paste(sheet,
              {left, pictures},
              make_cell(picture ? &*picture : nullptr, cell.width, cell.height, ground));
        draw_text(sheet, {left + 4, below + 4}, rows_[y].captions[x], kInk, scale);
      }
    }
    write_png(sheet, options_.output);
    fmt::print("{}: a row a condition, a picture at the centre of each phone\n", options_.output);
  }

 private:
  struct Row {
    std::string condition;
    std::vector<std::optional<Image>> pictures;  ///< absent: nothing is seen
    std::vector<std::string> captions;
  };

  struct Size {
    std::size_t width = 0;
    std::size_t height = 0;
  };

  [[nodiscard]] std::size_t least_height() const {
    return static_cast<std::size_t>(options_.height);
  }

  /// At the scale of the window, so that sizes can be compared.
  [[nodiscard]] std::optional<Image> scaled_picture(const Film& film, std::size_t number) const {
    if (number == Film::kBlank) return std::nullopt;
    const auto face_height = static_cast<std::size_t>(read_.protocol.window.face_height);
    const auto scaled = [&](std::size_t pixels) {
      return std::max<std::size_t>(1, pixels * least_height() / face_height);
    };
    const auto& picture = *film.pictures[number];
    return resized(picture, scaled(picture.width), scaled(picture.height));
  }

  void write_frames(const std::string& condition, const Film& film) const {
    const auto folder = std::filesystem::path{options_.frames} / condition;
    std::filesystem::create_directories(folder);
    for (std::size_t frame = 0; frame < film.picture_of_frame.size(); ++frame) {
      const auto number = film.picture_of_frame[frame];
      if (number == Film::kBlank) continue;
      write_png(*film.pictures[number], folder / fmt::format("frame{:04}.png", frame));
    }
  }

  const protocols::ReadProtocol& read_;
  const StripOptions& options_;
  Repertoire repertoire_;
  FilmStudio studio_;
  std::vector<Row> rows_;
};

ExitCode strip(const StripOptions& options) {
  if (options.output.empty() && options.frames.empty()) {
    throw Error{"nothing to write; give -o FILE.png or --frames FOLDER"};
  }
  const auto read = load_protocol(options.protocol);
  if (!read) return ExitCode::InvalidInput;
  const auto media = check_media(*read, find_protocol(options.protocol.named).string());
  print(media);
  if (has_errors(media)) return ExitCode::InvalidInput;
  const auto conditions = find_conditions(*read, options.conditions);
  const auto& word = find_word(*read, options.word);
  StripMaker maker{*read, options};
  for (const auto condition : conditions) maker.add(condition, word);
  maker.write();
  return ExitCode::Done;
}

}  // namespace

void add_stimuli_strip(CLI::App& stimuli, Verb& chosen) {
  auto* const verb = stimuli.add_subcommand(
      "strip",
      "Writes what is seen of one word as pictures: a row for each condition, in each row the\n"
      "picture at the centre of every phone, all at one scale.\n\n"
      "Examples:\n"
      "  bimodal stimuli strip words414 --corpus natural=my-talker --word stew -o stew.png\n"
      "  bimodal stimuli strip my.json --word ba --condition dubbed --frames ba-frames");
  auto options = std::make_shared<StripOptions>();
  add_protocol_options(*verb, options->protocol);
  verb->add_option("--word", options->word, "a word of the protocol")->required();
  verb->add_option("--condition",
                   options->conditions,
                   "a condition in which somebody is seen (all of them); may be given again")
      ->allow_extra_args(false)
      ->delimiter(',');
  verb->add_option("-o,--output", options->output, "the PNG file to be written")
      ->check(in_a_folder_that_exists());
  verb->add_option("--frames", options->frames, "folder for every frame: CONDITION/frame0000.png");
  verb->add_option("--refresh-hz", options->rate_hz, "refresh rate of the display (60)")
      ->check(CLI::Range(10.0, 1000.0));
  verb->add_option("--height", options->height, "of a picture of the window's face height (360)")
      ->check(CLI::Range(32, 4096));
  verb->callback([options, &chosen] { chosen = [options] { return strip(*options); }; });
}

}  // namespace bimodal::runner
