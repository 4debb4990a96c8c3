#include "runner/cli/reading_strips.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "stimuli/base/draft.hpp"
#include "stimuli/base/random.hpp"
#include "synth/speech/durations.hpp"

namespace bimodal::runner {

namespace {

/// Twelve consonants that look different, and the vowels around them.
constexpr std::array kReadConsonants{Phone::B,
                                     Phone::F,
                                     Phone::TH,
                                     Phone::D,
                                     Phone::S,
                                     Phone::SH,
                                     Phone::L,
                                     Phone::R,
                                     Phone::W,
                                     Phone::G,
                                     Phone::Y,
                                     Phone::HH};
constexpr std::array kReadVowels{Phone::AA, Phone::IY, Phone::UW};

}  // namespace

std::size_t write_reading_strips(SheetPainter& painter,
                                 std::uint64_t seed,
                                 const std::filesystem::path& folder) {
  constexpr std::array kPlaces{-1.0, -0.45, -0.15, 0.0, 0.15, 0.45, 1.0};
  constexpr Milliseconds kReach{170};
  std::vector<std::pair<Phone, Phone>> items;
  for (const Phone consonant : kReadConsonants) {
    for (const Phone vowel : kReadVowels) items.emplace_back(consonant, vowel);
  }
  Random random{seed};
  for (std::size_t i = items.size() - 1; i > 0; --i)
    std::swap(items[i], items[random.below(i + 1)]);
  std::filesystem::create_directories(folder);
  std::string key = "item,consonant,vowel\n";
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto [consonant, vowel] = items[i];
    const auto segments = synth::timed(std::array<Segment, 3>{vowel, consonant, vowel});
    const auto articulation = painter.articulation(segments);
    SheetRow row;
    for (const double place : kPlaces) {
      row.cells.push_back(painter.front(articulation, segments[2].centre() + place * kReach, ""));
    }
    write_png(contact_sheet({row}), folder / fmt::format("item{:02}.png", i + 1));
    key += fmt::format("{},{},{}\n", i + 1, symbol(consonant), symbol(vowel));
  }
  write_file(folder / "key.csv", key);
  return items.size();
}

}  // namespace bimodal::runner
