#include "stimuli/base/digest.hpp"

#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"

namespace bimodal {
namespace {

TEST(Sha256, AgreesWithTheStandardsExamples) {  // FIPS 180-4, "abc" and the empty message
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(ReadFile, NamesTheFileThatIsMissing) {
  try {
    static_cast<void>(read_file("no/such/file.json"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "cannot read 'no/such/file.json': No such file or directory; check the path and "
                 "its permissions");
  }
}

}  // namespace
}  // namespace bimodal
