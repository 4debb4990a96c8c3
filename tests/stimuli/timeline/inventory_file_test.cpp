#include "stimuli/timeline/inventory_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal {
namespace {

using testing::HasSubstr;

class InventoryFile : public testing::Test {
 protected:
  std::string message(const std::string& chosen) const {
    try {
      static_cast<void>(inventory_file(chosen, files_.folder()));
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  }

  WrittenFiles files_;
};

TEST_F(InventoryFile, IsOneThatShipsByItsName) {
  EXPECT_EQ(inventory_file("english").filename(), "english.json");
  EXPECT_EQ(inventory_file("english.json", files_.folder()), inventory_file("english"));
}

TEST_F(InventoryFile, IsAFileRelativeToTheFolder) {
  files_.write("english", "{}");
  EXPECT_EQ(inventory_file("english", files_.folder()), files_.folder() / "english");
}

TEST_F(InventoryFile, AFolderOfTheNameIsNoFile) {
  std::filesystem::create_directory(files_.folder() / "english");
  EXPECT_EQ(inventory_file("english", files_.folder()).filename(), "english.json");
}

TEST_F(InventoryFile, OtherwiseSaysWhatThereIs) {
  EXPECT_THAT(message("klingon"), HasSubstr("ships: english, turkish-plateau"));
  EXPECT_THAT(message("../../../etc/none.json"), HasSubstr("neither a file"));
  EXPECT_THAT(message("/dev/zero"), HasSubstr("cannot read the inventory"));
}

}  // namespace
}  // namespace bimodal
