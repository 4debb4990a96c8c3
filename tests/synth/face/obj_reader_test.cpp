#include "synth/face/obj_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "tests/synth/face/written_file.hpp"

namespace bimodal::synth {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string complaint(std::string_view text) {
  const WrittenFile file{text};
  try {
    (void)read_obj(file.path());
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(ObjReader, KeepsPartsApartAndCountsTheirVerticesFromZero) {
  const WrittenFile file{
      "# two parts\no one\nv 0 0 0\nv 1 0 0\nv 0 1 0\ng front\nf 1 2 3\n"
      "o two\r\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1.5 1\nf 4 5 6 7\n"};
  const auto cages = read_obj(file.path());
  ASSERT_EQ(cages.size(), 2U);
  EXPECT_EQ(cages[0].name, "one");
  EXPECT_THAT(cages[0].faces, ElementsAre(Face{0, 1, 2}));
  EXPECT_EQ(cages[1].name, "two");
  EXPECT_THAT(cages[1].faces, ElementsAre(Face{0, 1, 2, 3}));
  EXPECT_EQ(cages[1].vertices[3], (glm::dvec3{0.0, 1.5, 1.0}));
}

TEST(ObjReader, NamesTheLineOfAMalformedVertex) {
  EXPECT_THAT(complaint("o a\nv 0 0 0\nv 0 zero 0\n"), HasSubstr(":3: 'zero' is not a coordinate"));
  EXPECT_THAT(complaint("o a\nv 0 0\n"), HasSubstr(":2: '' is not a coordinate"));
  EXPECT_THAT(complaint("o a\nv 0 0 nan\n"), HasSubstr(":2: 'nan' is not a coordinate"));
}

TEST(ObjReader, NamesTheLineOfAFaceThatUsesAnotherPartsVertex) {
  EXPECT_THAT(complaint("o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"),
              HasSubstr(":5: '4' is not a vertex of this part, whose vertices are 1 to 3"));
  EXPECT_THAT(complaint("o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"), HasSubstr(":5: '0'"));
  EXPECT_THAT(complaint("o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/2 3/3\n"), HasSubstr(":5: '1/1'"));
  EXPECT_THAT(complaint("o a\nv 0 0 0\nv 1 0 0\nf 1 2\n"), HasSubstr("at least three vertices"));
}

TEST(ObjReader, RefusesAFileWithoutParts) {
  EXPECT_THAT(complaint("# nothing\n"), HasSubstr("no part"));
  EXPECT_THAT(complaint("v 0 0 0\n"), HasSubstr(":1: a vertex or face stands before"));
  EXPECT_THROW((void)read_obj("no/such/file.obj"), Error);
}

TEST(ObjReader, NamesAMissingPart) {
  const WrittenFile file{"o a\nv 0 0 0\n"};
  const auto cages = read_obj(file.path());
  EXPECT_THROW((void)part(cages, "b", file.path()), Error);
  EXPECT_EQ(part(cages, "a", file.path()).vertices.size(), 1U);
}

}  // namespace
}  // namespace bimodal::synth
