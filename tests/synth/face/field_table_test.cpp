#include "synth/face/field_table.hpp"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "tests/synth/face/written_file.hpp"

namespace bimodal::synth {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string complaint(const std::function<void()>& deed) {
  try {
    deed();
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

std::string complaint(std::string_view text) {
  const WrittenFile file{text};
  return complaint([&] { const FieldTable table{file.path()}; });
}

TEST(FieldTable, GivesColumnsByName) {
  const WrittenFile file{"ring,a_x,a_y,a_z\n-1,0.5,1e-3,2\r\n3,0,-4,5\n"};
  const FieldTable table{file.path()};
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_THAT(table.column("a_y"), ElementsAre(0.001, -4.0));
  EXPECT_THAT(table.whole_numbers("ring"), ElementsAre(-1, 3));
  EXPECT_THAT(table.vectors("a"), ElementsAre(glm::dvec3{0.5, 0.001, 2}, glm::dvec3{0, -4, 5}));
}

TEST(FieldTable, NamesTheLineOfAMalformedCell) {
  EXPECT_THAT(complaint("a,b\n1,2\n1,x\n"), HasSubstr(":3: 'x' is not a number"));
  EXPECT_THAT(complaint("a,b\n1,\n"), HasSubstr(":2: '' is not a number"));
  EXPECT_THAT(complaint("a,b\n1,inf\n"), HasSubstr(":2: 'inf' is not a number"));
  EXPECT_THAT(complaint("a,b\n1,2,3\n"), HasSubstr(":2: 3 cells, but the header has 2"));
  EXPECT_THAT(complaint("a,b\n1\n"), HasSubstr(":2: 1 cells, but the header has 2"));
}

TEST(FieldTable, RefusesAHeaderThatIsNotUnique) {
  EXPECT_THAT(complaint("a,a\n1,2\n"),
              HasSubstr(":1: the column name 'a' is empty or occurs twice"));
  EXPECT_THAT(complaint("a,\n1,2\n"), HasSubstr(":1: the column name ''"));
  EXPECT_THAT(complaint(""), HasSubstr("cannot read"));
}

TEST(FieldTable, NamesAMissingColumnAndAFractionWhereNoneMayBe) {
  const WrittenFile file{"ring,jaw\n1,0.5\n2.5,1\n"};
  const FieldTable table{file.path()};
  EXPECT_THAT(complaint([&] { (void)table.column("neck"); }), HasSubstr("'neck' is missing"));
  EXPECT_THAT(complaint([&] { (void)table.vectors("jaw"); }), HasSubstr("'jaw_x' is missing"));
  EXPECT_THAT(complaint([&] { (void)table.whole_numbers("ring"); }),
              HasSubstr(":3: column 'ring' holds 2.5"));
}

}  // namespace
}  // namespace bimodal::synth
