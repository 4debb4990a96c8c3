#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "synth/face/field_table.hpp"
#include "synth/face/obj_reader.hpp"

namespace bimodal::synth {

/// The files of synth/assets/head, read whole.
struct HeadFiles {
  std::filesystem::path mesh;
  std::vector<Cage> cages;
  FieldTable fields;  ///< one row per vertex of the skin's cage
  FieldTable teeth;   ///< one row per vertex of the upper teeth's cage, then of the lower's

  /// Throws Error where a file cannot be read or the files do not fit each other.
  explicit HeadFiles(const std::filesystem::path& folder);

  /// Throws Error if there is none of that name.
  [[nodiscard]] const Cage& part(std::string_view name) const;
};

}  // namespace bimodal::synth
