#include "runner/preparation/films_ahead.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/timeline/inventory_file.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

/// Two words that a small face says, and one that is only heard.
class FilmsAhead : public testing::Test {
 protected:
  FilmsAhead() {
    protocol_.window.face_height = 64;
    protocol_.intervals.lead = protocol_.intervals.trail = 0ms;
    protocols::Condition seen{.name = "seen", .visual_talker = "face"};
    seen.articulating.segments = inventory_file("english");
    protocol_.conditions = {seen, {.name = "heard", .auditory_talker = "festival:kal"}};
    plan_ = {{.word = {.spelling = "a", .phones = {Phone::AA}}},
             {.word = {.spelling = "e", .phones = {Phone::EH}}},
             {.word = {.spelling = "a", .phones = {Phone::AA}}, .condition = 1}};
  }

  /// What a session announces that finds `room` bytes in the cache.
  std::vector<std::string> draw(
      std::uintmax_t room, const Checkpoint& checkpoint = [] {}) {
    Repertoire repertoire{protocol_.sound.rate, no_corpora_};
    FilmStudio studio{
        protocol_.window, no_corpora_, synth::Quality::Fast, FilmCache{folder(), kEnough}};
    TrialPreparer preparer{protocol_, repertoire, &studio, Hertz{10}};
    std::vector<std::string> told;
    draw_films_ahead(plan_, preparer, room, 40s, checkpoint, [&](std::string_view what) {
      told.emplace_back(what);
    });
    return told;
  }

  [[nodiscard]] std::filesystem::path folder() const { return files_ / "cache/films"; }

  [[nodiscard]] std::size_t kept() const {
    if (!std::filesystem::exists(folder())) return 0;
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator{folder()},
                                                  std::filesystem::directory_iterator{}));
  }

  static constexpr std::uintmax_t kEnough = std::uintmax_t{1} << 30U;

  WrittenFiles files_;
  const std::map<std::string, Corpus> no_corpora_;
  protocols::Protocol protocol_;
  std::vector<protocols::PlannedTrial> plan_;
};

TEST_F(FilmsAhead, AreDrawnOnceAndToldOf) {
  EXPECT_THAT(draw(kEnough),
              ElementsAre("drawing 2 films of the face before the first trial: about 1 minute; "
                          "kept for later sessions",
                          HasSubstr("drawn 1 of 2 films; "),
                          "all films are drawn: the session can begin"));
  EXPECT_EQ(kept(), 2U);
  EXPECT_THAT(draw(kEnough), testing::IsEmpty());
}

TEST_F(FilmsAhead, EndWhereTheyWouldDriveOutTheFirst) {
  EXPECT_THAT(draw(100),
              ElementsAre(HasSubstr("2 films"), HasSubstr("drawn 1 of 2 films, and no")));
  EXPECT_EQ(kept(), 1U);
}

TEST_F(FilmsAhead, EndWhereTheyCannotBeKept) {
  files_.write("cache", "not a folder");
  EXPECT_THAT(draw(kEnough), ElementsAre(HasSubstr("2 films"), HasSubstr("cannot be kept")));
}

TEST_F(FilmsAhead, CanBeEndedBetweenPictures) {
  struct Enough {};

  int left = 6;
  EXPECT_THROW(draw(kEnough,
                    [&left] {
                      if (--left == 0) throw Enough{};
                    }),
               Enough);
  EXPECT_EQ(kept(), 0U);
}

TEST(AboutMinutes, AreRoundedAndCounted) {
  EXPECT_EQ(about_minutes(59s), "less than a minute");
  EXPECT_EQ(about_minutes(80s), "about 1 minute");
  EXPECT_EQ(about_minutes(37min + 40s), "about 38 minutes");
}

}  // namespace
}  // namespace bimodal::runner
