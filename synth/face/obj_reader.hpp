#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace bimodal::synth {

using Face =
    std::vector<std::uint32_t>;  ///< three or more vertex indices, counter-clockwise outside

/// One separately subdivided part of the head: an `o` section of a Wavefront OBJ file.
struct Cage {
  std::string name;
  std::vector<glm::dvec3> vertices;  ///< mm
  std::vector<Face> faces;           ///< indices into `vertices`, from 0
};

/// Reads `o`, `v` and `f` lines (only positions: "f 1 2 3"); groups, materials and comments are
/// passed over. A face may use only vertices of its own part. Throws Error naming file and line of
/// the first malformed line.
[[nodiscard]] std::vector<Cage> read_obj(const std::filesystem::path& file);

/// The part called `name`; throws Error if `cages`, read from `file`, lack it.
[[nodiscard]] const Cage& part(const std::vector<Cage>& cages,
                               std::string_view name,
                               const std::filesystem::path& file);

}  // namespace bimodal::synth
