#include "synth/speech/segment_table.hpp"

#include <cassert>

#include <fmt/format.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::synth {

static_assert(static_cast<std::size_t>(Phone::UW) + 1 == kFaceSegmentCount,
              "the diphthongs stand last, so that a phone is an index of the table");

SegmentTable::SegmentTable(const std::filesystem::path& file) {
  std::vector<Diagnostic> diagnostics;
  auto table = parse(read_file(file), file.string(), diagnostics);
  if (!table) {
    std::string message = fmt::format("cannot use the segment table '{}':", file.string());
    for (const auto& diagnostic : diagnostics) message += "\n  " + describe(diagnostic);
    throw Error{message};
  }
  *this = *std::move(table);
}

const SegmentTarget& SegmentTable::at(Phone segment, Control control) const {
  const auto row = static_cast<std::size_t>(segment);
  const auto column = static_cast<std::size_t>(control);
  assert(row < kFaceSegmentCount && column < kSpeechControlCount);
  return targets_[row][column];
}

}  // namespace bimodal::synth
