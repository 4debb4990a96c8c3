#include "stimuli/corpus/contact_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "stimuli/picture/drawing.hpp"
#include "stimuli/video/frame_reader.hpp"
#include "stimuli/video/sound_track.hpp"

namespace bimodal {

namespace {

constexpr std::size_t kItemsPerPage = 48;
constexpr std::size_t kColumns = 4;
constexpr std::int64_t kCellWidth = 400;
constexpr std::int64_t kGap = 10;
constexpr std::size_t kFrameHeight = 96;
constexpr std::int64_t kFrameSpace = 100;
constexpr std::int64_t kTextSpace = 34;
constexpr std::int64_t kWaveHeight = 64;
constexpr std::int64_t kLabelHeight = 12;

constexpr Colour kPaper{255, 255, 255};
constexpr Colour kInk{30, 30, 30};
constexpr Colour kPale{150, 150, 150};
constexpr Colour kMargin{242, 242, 238};
constexpr Colour kOthers{215, 215, 215};
constexpr Colour kDoubt{190, 20, 20};
constexpr Colour kWave{40, 80, 150};
constexpr Colour kEdge{200, 120, 40};

double seconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

Duration middle_of_vowel(const CorpusItem& item) {
  const auto vowel = std::ranges::find_if(
      item.phones, [](const TimedPhone& timed) { return is_vowel(timed.phone); });
  if (vowel == item.phones.end()) {
    return (item.phones.front().start + item.phones.back().end()) / 2;
  }
  return vowel->start + vowel->duration / 2;
}

/// First, middle and last frame, small.
std::vector<Image> three_frames(const std::filesystem::path& file, const CorpusItem& item) {
  FrameReader reader{file, {.height = kFrameHeight, .span = {item.start, item.end}}};
  const auto middle = middle_of_vowel(item);
  std::array<std::optional<Image>, 3> kept;
  while (auto frame = reader.next()) {
    if (!kept[0]) kept[0] = frame->image;
    if (frame->start <= middle || !kept[1]) kept[1] = frame->image;
    kept[2] = std::move(frame->image);
  }
  std::vector<Image> frames;
  for (auto& image : kept) {
    if (image) frames.push_back(std::move(*image));
  }
  return frames;
}

/// What fits into a width.
std::string shortened(std::string text, std::int64_t width) {
  const auto most = static_cast<std::size_t>(width / kLetter.width);
  if (text.size() > most) text = text.substr(0, most - 3) + "...";
  return text;
}

/// What one cell shows.
struct Cell {
  const CorpusItem* item;
  std::vector<Image> frames;
  Clip sound;  ///< of the item; empty if it could not be read
};

class Sheet {
 public:
  Sheet(const Corpus& corpus, const Progress& progress) : corpus_{corpus}, progress_{progress} {}

  ContactSheet draw(const std::filesystem::path& file) {
    if (corpus_.items.empty()) throw Error{"cannot draw a sheet: there are no items to be drawn"};
    for (const auto& item : corpus_.items) longest_ = std::max(longest_, item.end - item.start);
    longest_ = std::min<Duration>(longest_, std::chrono::seconds{3});
    const auto pages = (corpus_.items.size() + kItemsPerPage - 1) / kItemsPerPage;
    for (std::size_t page = 0; page < pages; ++page) {
      auto name = file;
      if (pages > 1) {
        name.replace_filename(
            fmt::format("{}-{}{}", file.stem().string(), page + 1, file.extension().string()));
      }
      write_png(draw_page(page), name);
      sheet_.files.push_back(name);
    }
    return std::move(sheet_);
  }

 private:
  Cell read_cell(const CorpusItem& item) {
    Cell cell{&item, {}, {}};
    const auto file = media_file(corpus_, item.recording);
    const auto note = [&](const Error& error) {
      sheet_.findings.push_back(fmt::format("{}: {}", item.name, describe(error)));
    };
    try {
      cell.sound = read_sound_track(file, Hertz{0}, {item.start, item.end});
    } catch (const Error& error) {
      note(error);
    }
    if (!has_picture(item.recording)) return cell;
    try {
      cell.frames = three_frames(file, item);
    } catch (const Error& error) {
      note(error);
    }
    return cell;
  }

  bool has_picture(std::size_t recording) {
    has_picture_.resize(corpus_.recordings.size());
    auto& known = has_picture_[recording];
    if (!known) {
      try {
        known = examine_media(media_file(corpus_, recording)).picture.has_value();
      } catch (const Error&) {
        known = false;  // reading its sound has told why
      }
    }
    return *known;
  }

  Image draw_page(std::size_t page) {
    const auto first = page * kItemsPerPage;
    const auto end = std::min(first + kItemsPerPage, corpus_.items.size());
    std::vector<Cell> cells;
    float peak = 1e-6F;
    for (std::size_t i = first; i < end; ++i) {
      cells.push_back(read_cell(corpus_.items[i]));
      for (const float sample : cells.back().sound.samples) peak = std::max(peak, std::abs(sample));
      if (progress_) {
        progress_("drawing the sheet",
                  static_cast<double>(i + 1) / static_cast<double>(corpus_.items.size()));
      }
    }
    const bool seen =
        std::ranges::any_of(cells, [](const Cell& cell) { return !cell.frames.empty(); });
    const std::int64_t frame_space = seen ? kFrameSpace : 0;
    const std::int64_t cell_height = frame_space + kTextSpace + kWaveHeight + kLabelHeight + kGap;
    const auto columns = std::min(kColumns, cells.size());
    const auto rows = (cells.size() + columns - 1) / columns;
    auto image = blank_image(
        static_cast<std::size_t>(kGap + static_cast<std::int64_t>(columns) * (kCellWidth + kGap)),
        static_cast<std::size_t>(kGap + static_cast<std::int64_t>(rows) * cell_height),
        kPaper);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Place corner{kGap + static_cast<std::int64_t>(i % columns) * (kCellWidth + kGap),
                         kGap + static_cast<std::int64_t>(i / columns) * cell_height};
      draw_frames(image, corner, cells[i].frames);
      draw_name(image, {corner.x, corner.y + frame_space}, *cells[i].item);
      draw_wave(image, {corner.x, corner.y + frame_space + kTextSpace}, cells[i], peak);
    }
    return image;
  }

  static void draw_frames(Image& image, Place corner, const std::vector<Image>& frames) {
    for (const auto& frame : frames) {
      paste(image, corner, frame);
      corner.x += static_cast<std::int64_t>(frame.width) + 2;
    }
  }

  void draw_name(Image& image, Place corner, const CorpusItem& item) const {
    const bool doubtful = !item.doubt.empty();
    constexpr std::int64_t kLarge = 2;
    draw_text(image, corner, item.name, doubtful ? kDoubt : kInk, kLarge);
    const auto where =
        fmt::format("{:.2f} s  {}", seconds(item.start), corpus_.recordings[item.recording].file);
    const auto beside = corner.x + text_width(item.name, kLarge) + kLetter.width;
    const auto room = corner.x + kCellWidth - beside;
    if (room > 10 * kLetter.width) {
      draw_text(image, {beside, corner.y + 6}, shortened(where, room), kPale);
    }
    if (doubtful) {
      draw_text(image, {corner.x, corner.y + 20}, shortened(item.doubt, kCellWidth), kDoubt);
    }
  }

  [[nodiscard]] std::int64_t column_of(const CorpusItem& item, Duration time) const {
    const double part = seconds(time - item.start) / seconds(longest_);
    return std::min(kCellWidth, static_cast<std::int64_t>(std::lround(part * kCellWidth)));
  }

  void shade(Image& image,
             Place corner,
             const CorpusItem& item,
             SpeechInterval part,
             Colour colour) const {
    const auto from = column_of(item, part.start);
    fill(image,
         {corner.x + from, corner.y},
         {column_of(item, part.end) - from, kWaveHeight},
         colour);
  }

  void draw_wave(Image& image, Place corner, const Cell& cell, float peak) const {
    const auto& item = *cell.item;
    const auto clear = item.clear.value_or(SpeechInterval{item.start, item.end});
    shade(image, corner, item, {item.start, item.end}, kMargin);
    shade(image, corner, item, {item.start, clear.start}, kOthers);
    shade(image, corner, item, {clear.end, item.end}, kOthers);
    draw_samples(image, corner, cell, peak);
    for (const auto& timed : item.phones) {
      const auto from = column_of(item, timed.start);
      const auto to = column_of(item, timed.end());
      fill(image, {corner.x + from, corner.y}, {1, kWaveHeight + kLabelHeight}, kEdge);
      const auto name = symbol(timed.phone);
      const auto left = std::max(from + 2, (from + to - text_width(name)) / 2);
      draw_text(image, {corner.x + left, corner.y + kWaveHeight + 3}, name, kInk);
    }
    const auto last = column_of(item, item.phones.back().end());
    fill(image, {corner.x + last, corner.y}, {1, kWaveHeight + kLabelHeight}, kEdge);
  }

  /// From the lowest to the highest sample of each column.
  void draw_samples(Image& image, Place corner, const Cell& cell, float peak) const {
    const auto& samples = cell.sound.samples;
    if (samples.empty()) return;
    const auto width = column_of(*cell.item, cell.item->end);
    const auto row = [&](float sample) {
      const double height = (1.0 - static_cast<double>(sample / peak)) * (kWaveHeight - 1) / 2.0;
      return static_cast<std::int64_t>(std::lround(height));
    };
    for (std::int64_t x = 0; x < width; ++x) {
      const auto count = static_cast<std::int64_t>(samples.size());
      const auto first = x * count / width;
      const auto end = std::max(first + 1, (x + 1) * count / width);
      if (first >= count) break;
      const auto [low, high] =
          std::minmax_element(samples.begin() + first, samples.begin() + std::min(end, count));
      fill(image, {corner.x + x, corner.y + row(*high)}, {1, row(*low) - row(*high) + 1}, kWave);
    }
  }

  const Corpus& corpus_;
  const Progress& progress_;
  Duration longest_{};
  std::vector<std::optional<bool>> has_picture_;
  ContactSheet sheet_;
};

}  // namespace

ContactSheet draw_contact_sheet(const Corpus& corpus,
                                const std::filesystem::path& file,
                                const Progress& progress) {
  return Sheet{corpus, progress}.draw(file);
}

}  // namespace bimodal
