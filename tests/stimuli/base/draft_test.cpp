#include "stimuli/base/draft.hpp"

#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal {
namespace {

class DraftTest : public testing::Test {
 public:
  DraftTest()
      : folder_{std::filesystem::path{testing::TempDir()} /
                ("bimodal_draft_" + std::to_string(::getpid()))} {
    std::filesystem::create_directories(folder_);
    std::ofstream{target()} << "before";
  }

  DraftTest(const DraftTest&) = delete;
  DraftTest& operator=(const DraftTest&) = delete;
  DraftTest(DraftTest&&) = delete;
  DraftTest& operator=(DraftTest&&) = delete;

  ~DraftTest() override { std::filesystem::remove_all(folder_); }

 protected:
  [[nodiscard]] std::filesystem::path target() const { return folder_ / "a.txt"; }

  [[nodiscard]] std::ptrdiff_t files() const {
    const std::filesystem::directory_iterator entries{folder_};
    return std::distance(begin(entries), end(entries));
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(DraftTest, ReplacesItsTargetOnlyWhenItIsKept) {
  {
    Draft draft{target()};
    std::ofstream{draft.path()} << "after";
    EXPECT_EQ(read_file(target()), "before");
  }
  EXPECT_EQ(read_file(target()), "before");
  EXPECT_EQ(files(), 1);
  write_file(target(), "after");
  EXPECT_EQ(read_file(target()), "after");
  EXPECT_EQ(files(), 1);
}

TEST_F(DraftTest, NamesTheTargetThatCannotBeWritten) {
  try {
    write_file(target() / "b.txt", "after");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string{error.what()}.find("a.txt/b.txt': "), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace bimodal
