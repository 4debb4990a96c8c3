#include "synth/face/head_files.hpp"

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "synth/face/tongue.hpp"

namespace bimodal::synth {

namespace {

void require_rows(const FieldTable& table, const std::filesystem::path& file, std::size_t rows) {
  if (table.rows() == rows) return;
  throw Error{
      fmt::format("{}: {} rows, but head.obj has {} vertices to describe; regenerate both "
                  "with tools/head",
                  file.string(),
                  table.rows(),
                  rows)};
}

}  // namespace

HeadFiles::HeadFiles(const std::filesystem::path& folder)
    : mesh{folder / "head.obj"},
      cages{read_obj(mesh)},
      fields{folder / "fields.csv"},
      teeth{folder / "teeth.csv"} {
  require_rows(fields, folder / "fields.csv", part("skin").vertices.size());
  require_rows(teeth,
               folder / "teeth.csv",
               part("upper_teeth").vertices.size() + part("lower_teeth").vertices.size());
  if (part("tongue").vertices.size() == kTongueVertices) return;
  throw Error{
      fmt::format("{}: the tongue has {} vertices, not {}; regenerate the file with "
                  "tools/head",
                  mesh.string(),
                  part("tongue").vertices.size(),
                  kTongueVertices)};
}

const Cage& HeadFiles::part(std::string_view name) const {
  return synth::part(cages, name, mesh);
}

}  // namespace bimodal::synth
