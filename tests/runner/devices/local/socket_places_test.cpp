#include "runner/devices/local/socket_places.hpp"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/written_files.hpp"

namespace bimodal::runner {
namespace {

using ::testing::SizeIs;

TEST(SocketPlaces, AreFirstOfAllBesideTheDataFile) {
  const WrittenFiles files;
  const auto places = socket_places(files / "x.sqlite", ".monitor");
  ASSERT_FALSE(places.empty());
  EXPECT_EQ(places.front(), files / "x.sqlite.monitor");
}

TEST(SocketPlaces, AreTheSameHoweverTheFileIsNamed) {
  const WrittenFiles files;
  files.write("data/x.sqlite", "");
  std::filesystem::create_directory_symlink("data", files / "link");
  const auto places = socket_places(files / "data/x.sqlite", ".monitor");
  EXPECT_EQ(socket_places(files / "data/../data/x.sqlite", ".monitor"), places);
  EXPECT_EQ(socket_places(files / "link/x.sqlite", ".monitor"), places);
  EXPECT_NE(socket_places(files / "data/y.sqlite", ".monitor"), places);
}

TEST(SocketPlaces, AreElsewhereWhereAPathIsTooLong) {
  const WrittenFiles files;
  const auto data = files / std::string(100, 'x') / "x.sqlite";
  setenv("XDG_RUNTIME_DIR", "/run/user/7", 1);
  const auto places = socket_places(data, ".monitor");
  unsetenv("XDG_RUNTIME_DIR");
  ASSERT_THAT(places, SizeIs(2));
  EXPECT_EQ(places[0].parent_path(), "/run/user/7");
  EXPECT_EQ(places[1].parent_path(), "/tmp");
  EXPECT_EQ(places[0].filename(), places[1].filename());
  EXPECT_NE(places[0].filename(),
            socket_places(files / std::string(100, 'x') / "y.sqlite", ".monitor")[0].filename());
}

}  // namespace
}  // namespace bimodal::runner
