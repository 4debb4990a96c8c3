#pragma once

#include <cstdint>
#include <filesystem>

#include "runner/cli/sheet_painter.hpp"

namespace bimodal::runner {

/// Writes a test of reading into a folder: 36 unlabelled strips item01.png ..., seven pictures from
/// 170 ms before to 170 ms after the middle of a consonant between two vowels, in an order of the
/// seed, and key.csv (item, consonant, vowel). Returns how many strips. Throws Error if something
/// cannot be written.
std::size_t write_reading_strips(SheetPainter& painter,
                                 std::uint64_t seed,
                                 const std::filesystem::path& folder);

}  // namespace bimodal::runner
