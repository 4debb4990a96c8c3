#include "stimuli/labels/label_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <iterator>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/labels/align_file.hpp"
#include "stimuli/labels/csv_labels.hpp"
#include "stimuli/labels/lab_file.hpp"
#include "stimuli/labels/label_lines.hpp"
#include "stimuli/labels/label_time.hpp"
#include "stimuli/labels/text_encoding.hpp"
#include "stimuli/labels/text_grid.hpp"
#include "stimuli/labels/tier_builder.hpp"

namespace bimodal {

namespace {

constexpr std::uintmax_t kLargestLabelFile = 16UL << 20U;  ///< bytes

enum class Format { TextGrid, Lab, Align, Csv };

struct Ending {
  std::string_view text;
  Format format;
};

constexpr std::array<Ending, 4> kEndings{{{".textgrid", Format::TextGrid},
                                          {".lab", Format::Lab},
                                          {".align", Format::Align},
                                          {".csv", Format::Csv}}};

Format format_of(const std::filesystem::path& file) {
  auto ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  const auto* const found = std::ranges::find(kEndings, std::string_view{ending}, &Ending::text);
  if (found == kEndings.end()) {
    refuse({file.native()},
           "the name does not tell a format of labels",
           "let it end in .TextGrid, .lab, .align or .csv");
  }
  return found->format;
}

[[noreturn]] void refuse_size(const std::filesystem::path& file, std::uintmax_t size) {
  refuse(
      {file.native()},
      fmt::format("{} bytes are more than the {} MB that we read", size, kLargestLabelFile >> 20U),
      "is this the right file?");
}

[[noreturn]] void refuse_writing(const std::filesystem::path& file,
                                 const std::string& finding,
                                 std::string_view remedy) {
  throw Error{fmt::format("cannot write '{}': {}; {}", file.string(), finding, remedy)};
}

/// What Labels promises; a reader would refuse it otherwise.
void require_sound(const Labels& labels, const std::filesystem::path& file) {
  if (labels.end > kLatestTime) {
    refuse_writing(file,
                   fmt::format("the labels end at {} s", seconds_text(labels.end)),
                   "give labels of one recording");
  }
  for (const auto& tier : labels.tiers) {
    Duration reached{};
    for (const auto& label : tier.labels) {
      const auto refuse_this = [&](std::string_view finding, std::string_view remedy) {
        refuse_writing(
            file,
            fmt::format("tier \"{}\": the label {} {}", tier.name, in_quotes(label.text), finding),
            remedy);
      };
      if (label.start < reached || label.end < label.start || label.end > labels.end) {
        refuse_this("is out of order or beyond the end", "give labels in order of time");
      }
      if (!is_plain_text(label.text) || trimmed(label.text) != label.text) {
        refuse_this("is no text in UTF-8 without blanks at its ends", "mend it");
      }
      reached = label.end;
    }
    if (!is_plain_text(tier.name)) {
      refuse_writing(file, "the name of a tier is no text in UTF-8", "rename it");
    }
  }
}

/// The tier for a format that holds one.
Tier only_tier(const Labels& labels, const std::filesystem::path& file) {
  if (labels.tiers.empty()) refuse_writing(file, "there is no tier", "give labels with one");
  Tier tier{.name = labels.tiers.front().name, .labels = {}};
  std::ranges::copy_if(
      labels.tiers.front().labels, std::back_inserter(tier.labels), [](const Label& label) {
        return !label.text.empty() || label.start == label.end;
      });
  if (tier.labels.empty()) {
    refuse_writing(file,
                   fmt::format("the tier \"{}\" has no labels", tier.name),
                   "choose another tier, or write a TextGrid");
  }
  return tier;
}

std::string align_of(const Labels& labels, const std::filesystem::path& file) {
  auto tier = only_tier(labels, file);
  for (const auto& label : tier.labels) {
    if (label.text.empty() || label.text.find('\n') != std::string::npos) {
      refuse_writing(file,
                     fmt::format("the label {} at {} s is not one line of text",
                                 in_quotes(label.text),
                                 seconds_text(label.start)),
                     "write a TextGrid or CSV");
    }
  }
  return align_text(tier);
}

std::string csv_of(const Labels& labels, const std::filesystem::path& file) {
  std::set<std::string_view> names;
  for (const auto& tier : labels.tiers) {
    if (!names.insert(tier.name).second) {
      refuse_writing(file,
                     fmt::format("two tiers are called \"{}\", which a table would mix", tier.name),
                     "rename one, or write a TextGrid");
    }
  }
  return csv_labels(labels);
}

}  // namespace

Labels read_labels(const std::filesystem::path& file) {
  (void)format_of(file);
  std::error_code unknown;
  const auto size = std::filesystem::file_size(file, unknown);
  if (!unknown && size > kLargestLabelFile) refuse_size(file, size);
  return parse_labels(read_file(file), file.string());
}

Labels parse_labels(std::string_view bytes, const std::string& name) {
  const Format format = format_of(name);
  if (bytes.size() > kLargestLabelFile) refuse_size(name, bytes.size());
  if (bytes.starts_with("ooBinaryFile")) {
    refuse({name}, "this is a binary Praat file", "in Praat, choose 'Save as text file...'");
  }
  const auto text = decode_text(bytes, name);
  switch (format) {
    case Format::TextGrid:
      return parse_text_grid(text, name);
    case Format::Lab:
      return parse_lab(text, name);
    case Format::Align:
      return parse_align(text, name);
    case Format::Csv:
      break;
  }
  return parse_csv_labels(text, name);
}

void write_labels(const std::filesystem::path& file, const Labels& labels) {
  const Format format = format_of(file);
  require_sound(labels, file);
  switch (format) {
    case Format::TextGrid:
      return write_file(file, text_grid(labels));
    case Format::Lab:
      return write_file(file, htk_lab(only_tier(labels, file)));
    case Format::Align:
      return write_file(file, align_of(labels, file));
    case Format::Csv:
      break;
  }
  write_file(file, csv_of(labels, file));
}

bool holds_one_tier(const std::filesystem::path& file) {
  const Format format = format_of(file);
  return format == Format::Lab || format == Format::Align;
}

}  // namespace bimodal
