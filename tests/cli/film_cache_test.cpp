// Films of the face that are kept from session to session.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/cli/command_line.hpp"

namespace bimodal {
namespace {

using ::testing::HasSubstr;

class KeptFilms : public CommandLine {
 protected:
  KeptFilms() {
    files_.write(
        "seen.json",
        replaced(
            replaced(kProtocol,
                     R"("name": "voice", "auditory": {"talker": "festival:kal"}, "snr_db": -4)",
                     R"("name": "face", "visual": {"talker": "face"})"),
            R"("seed": 1,)",
            R"("seed": 1, "window": {"face_height": 96},)"));
  }

  [[nodiscard]] Ended run(const std::string& participant, const std::vector<std::string>& more) {
    std::vector<std::string> last{
        "--participant", participant, "--data", "x.sqlite", "--trials", "1", "--no-practice"};
    last.insert(last.end(), more.begin(), more.end());
    return bimodal(unattended_run("seen.json", last), {"BIMODAL_CACHE=" + path("cache")});
  }

  /// The kept film's name and content; empty if there is not one alone.
  [[nodiscard]] std::string kept() const {
    const std::filesystem::path folder{path("cache/films")};
    if (!std::filesystem::exists(folder)) return {};
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator{folder}) {
      names.push_back(entry.path().filename());
    }
    return names.size() == 1 ? names.front() + bytes("cache/films/" + names.front()) : "";
  }
};

TEST_F(KeptFilms, AreUsedByTheNextSessionAndNotWithNoCache) {
  EXPECT_THAT(run("P01", {"--no-cache"}), ended(ExitCode::Done, HasSubstr("complete")));
  EXPECT_FALSE(std::filesystem::exists(path("cache")));
  ASSERT_THAT(run("P01", {"--again"}), ended(ExitCode::Done, HasSubstr("complete")));
  const auto first = kept();
  ASSERT_FALSE(first.empty());
  EXPECT_THAT(run("P01", {"--again"}), ended(ExitCode::Done, HasSubstr("complete")));
  EXPECT_EQ(kept(), first);
}

}  // namespace
}  // namespace bimodal
