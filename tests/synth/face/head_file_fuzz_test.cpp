// Damaged files of the head become a head's parts and fields, or an error that names the file;
// never anything else.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "synth/face/field_table.hpp"
#include "synth/face/obj_reader.hpp"
#include "tests/support/damage.hpp"
#include "tests/synth/face/written_file.hpp"

namespace bimodal::synth {
namespace {

using testing::HasSubstr;

constexpr int kMutations = 3'000;

/// Lets `read` judge each damaged file: true where it is taken. What it throws must name the file.
template <typename Read>
void damage_and_read(std::string_view valid, std::uint32_t seed, const Read& read) {
  Damage damage{seed};
  int accepted = 0;
  for (int i = 0; i < kMutations; ++i) {
    const WrittenFile file{damage(std::string{valid})};
    try {
      ASSERT_NO_FATAL_FAILURE(read(file.path()));
      ++accepted;
    } catch (const Error& error) {
      ASSERT_THAT(error.what(), HasSubstr(file.path().filename().string()));
    }
  }
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, kMutations);
}

TEST(HeadFileFuzz, DamagedCagesAreCagesOrErrors) {
  constexpr std::string_view kCages =
      "# a cube's corner\no skin\nv 0 0 0\nv 1.5 0 0\nv 0 -2.25 0\nv 0 0 3e1\ng front\n"
      "usemtl skin\nf 1 2 3\nf 1 3 4 2\no tongue\r\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1.5 1\n"
      "f 5 6 7 8\n";
  damage_and_read(kCages, 1, [](const std::filesystem::path& file) {
    const auto cages = read_obj(file);
    ASSERT_FALSE(cages.empty());
    for (const auto& cage : cages) {
      for (const auto& vertex : cage.vertices) {
        ASSERT_TRUE(std::isfinite(vertex.x + vertex.y + vertex.z));
      }
      for (const auto& face : cage.faces) {
        ASSERT_GE(face.size(), 3U);
        for (const auto corner : face) ASSERT_LT(corner, cage.vertices.size());
      }
    }
  });
}

TEST(HeadFileFuzz, DamagedFieldsAreFieldsOrErrors) {
  constexpr std::string_view kFields =
      "vertex,jaw_x,jaw_y,jaw_z,weight\n0,0,-1.5,0.25,1\n1,0.5,1e-3,-2,0.75\n2,0,0,0,0\r\n"
      "3,-0.125,4,5e1,1\n";
  damage_and_read(kFields, 2, [](const std::filesystem::path& file) {
    const FieldTable table{file};
    const auto weights = table.column("weight");
    ASSERT_EQ(weights.size(), table.rows());
    for (const double weight : weights) ASSERT_TRUE(std::isfinite(weight));
    ASSERT_EQ(table.vectors("jaw").size(), table.rows());
    ASSERT_EQ(table.whole_numbers("vertex").size(), table.rows());
  });
}

}  // namespace
}  // namespace bimodal::synth
