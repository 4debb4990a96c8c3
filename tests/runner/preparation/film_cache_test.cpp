#include "runner/preparation/film_cache.hpp"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "runner/preparation/film_file.hpp"
#include "runner/preparation/film_key.hpp"
#include "runner/preparation/film_studio.hpp"
#include "stimuli/base/digest.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

const Checkpoint kNoRest = [] {};

/// A film of three pictures, of which the first stands still and a blank follows the last.
Film film_of(std::uint8_t level) {
  Film film;
  for (std::uint8_t i = 0; i < 3; ++i) {
    Image image{.width = 16, .height = 9, .pixels = std::vector<std::uint8_t>(16 * 9 * 4, level)};
    for (std::size_t k = i; k < image.pixels.size(); k += 7) image.pixels[k] ^= i;
    film.pictures.push_back(std::make_shared<const Image>(std::move(image)));
  }
  film.picture_of_frame = {0, 0, 1, 2, Film::kBlank};
  return film;
}

bool equal(const Film& one, const Film& other) {
  return one.picture_of_frame == other.picture_of_frame &&
         one.source_frame_of_picture == other.source_frame_of_picture &&
         std::ranges::equal(one.pictures, other.pictures, [](const auto& a, const auto& b) {
           return a->width == b->width && a->height == b->height && a->pixels == b->pixels;
         });
}

class FilmCaches : public testing::Test {
 protected:
  [[nodiscard]] fs::path folder() const { return files_ / "cache/films"; }

  [[nodiscard]] std::size_t kept() const {
    if (!fs::exists(folder())) return 0;
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator{folder()}, fs::directory_iterator{}));
  }

  /// As if the film had last been used so long ago.
  void age(const std::string& key, std::chrono::minutes ago) const {
    fs::last_write_time(folder() / (key + ".film"), fs::file_time_type::clock::now() - ago);
  }

  WrittenFiles files_;
};

TEST_F(FilmCaches, GiveBackTheVeryFilm) {
  const FilmCache cache{folder()};
  EXPECT_FALSE(cache.find("a", kNoRest));
  cache.keep("a", film_of(40), kNoRest);
  cache.keep("b", film_of(50), kNoRest);
  const auto found = cache.find("a", kNoRest);
  ASSERT_TRUE(found);
  EXPECT_TRUE(equal(*found, film_of(40)));
  EXPECT_FALSE(cache.find("c", kNoRest));
  cache.keep("empty", Film{}, kNoRest);
  EXPECT_TRUE(equal(cache.find("empty", kNoRest).value(), Film{}));
}

TEST_F(FilmCaches, RestBetweenPicturesWhenTheyAreAskedTo) {
  const FilmCache cache{folder()};
  int rests = 0;
  const Checkpoint checkpoint = [&rests] { ++rests; };
  cache.keep("a", film_of(40), checkpoint);
  EXPECT_EQ(rests, 3);
  EXPECT_TRUE(cache.find("a", checkpoint));
  EXPECT_EQ(rests, 6);
}

TEST_F(FilmCaches, NeverGiveOutWhatIsDamaged) {
  const FilmCache cache{folder()};
  cache.keep("a", film_of(40), kNoRest);
  const auto file = folder() / "a.film";
  const auto whole = read_file(file);
  const auto is_refused = [&](const std::string& bytes) {
    std::ofstream{file, std::ios::binary} << bytes;
    const bool found = cache.find("a", kNoRest).has_value();
    return !found && !fs::exists(file);
  };
  for (std::size_t i = 0; i < whole.size(); i += 5) {
    auto bytes = whole;
    bytes[i] = static_cast<char>(bytes[i] ^ 4);
    EXPECT_TRUE(is_refused(bytes)) << i;
    EXPECT_TRUE(is_refused(whole.substr(0, i))) << i;
  }
  EXPECT_TRUE(is_refused(whole + "x"));
  // Another film under this name.
  cache.keep("b", film_of(50), kNoRest);
  EXPECT_TRUE(is_refused(read_file(folder() / "b.film")));
}

TEST_F(FilmCaches, DoNotCountAFilmWithoutItsEndAsKept) {
  const FilmCache cache{folder()};
  cache.keep("a", film_of(4), kNoRest);
  const auto file = folder() / "a.film";
  const auto size = fs::file_size(file);
  EXPECT_EQ(cache.use("a"), size);
  fs::resize_file(file, size - 1);
  fs::resize_file(file, size);  // with a byte of 0 at its end, as a power cut may leave it
  EXPECT_FALSE(cache.use("a"));
  fs::resize_file(file, 0);
  EXPECT_FALSE(cache.use("a"));
}

TEST_F(FilmCaches, DropTheFilmsThatHaveNotBeenUsedForLongest) {
  const auto one = packed(film_of(40), "a", kNoRest).size();
  const FilmCache cache{folder(), 3 * one + one / 2};
  for (const std::string key : {"a", "b", "c"}) cache.keep(key, film_of(40), kNoRest);
  age("a", 3min);
  age("b", 2min);
  age("c", 1min);
  EXPECT_TRUE(cache.find("a", kNoRest));  // used now
  cache.keep("d", film_of(40), kNoRest);
  EXPECT_EQ(kept(), 3U);
  EXPECT_FALSE(cache.find("b", kNoRest));
  for (const std::string key : {"a", "c", "d"}) EXPECT_TRUE(cache.find(key, kNoRest)) << key;
}

TEST_F(FilmCaches, KeepNothingThatIsLargerThanAllTheirRoom) {
  const FilmCache cache{folder(), 100};
  cache.keep("a", film_of(40), kNoRest);
  EXPECT_EQ(kept(), 0U);
}

TEST_F(FilmCaches, RemoveWhatAKilledProcessHasLeft) {
  const FilmCache cache{folder()};
  cache.keep("a", film_of(40), kNoRest);
  const auto left = files_.write("cache/films/b.film.123.part", "half");
  fs::last_write_time(left, fs::file_time_type::clock::now() - 2h);
  files_.write("cache/films/c.film.124.part", "being written");
  cache.keep("d", film_of(40), kNoRest);
  EXPECT_FALSE(fs::exists(left));
  EXPECT_EQ(kept(), 3U);
}

TEST_F(FilmCaches, ArePrivate) {
  const FilmCache cache{folder()};
  cache.keep("a", film_of(40), kNoRest);
  EXPECT_EQ(fs::status(folder()).permissions(), fs::perms::owner_all);
  ASSERT_TRUE(cache.find("a", kNoRest));
  fs::permissions(folder(), fs::perms::all);
  EXPECT_FALSE(cache.find("a", kNoRest));
  cache.keep("b", film_of(40), kNoRest);
  EXPECT_EQ(kept(), 1U);
}

TEST_F(FilmCaches, AreAsIfEmptyWhereNothingCanBeWritten) {
  const FilmCache cache{files_.write("file", "") / "films"};
  cache.keep("a", film_of(40), kNoRest);
  EXPECT_FALSE(cache.find("a", kNoRest));
}

TEST_F(FilmCaches, MayBeSharedByProcesses) {
  const auto size = packed(film_of(0), "0", kNoRest).size();
  const FilmCache cache{folder(), 4 * size};  // so that they also remove each other's
  const auto work = [&] {
    bool is_sound = true;
    for (int round = 0; round < 200; ++round) {
      const auto level = static_cast<std::uint8_t>(round % 8);
      const auto key = std::to_string(level);
      if (const auto found = cache.find(key, kNoRest)) {
        is_sound = is_sound && equal(*found, film_of(level));
      } else {
        cache.keep(key, film_of(level), kNoRest);
      }
    }
    return is_sound;
  };
  const auto other = ::fork();
  ASSERT_NE(other, -1);
  if (other == 0) ::_exit(work() ? 0 : 1);
  EXPECT_TRUE(work());
  int status = -1;
  ::waitpid(other, &status, 0);
  EXPECT_EQ(status, 0);
}

/// Sets and unsets variables for as long as it lives.
class ChangedEnvironment {
 public:
  ChangedEnvironment() {
    for (const auto* const name : {"HOME", "XDG_CACHE_HOME", "BIMODAL_CACHE"}) {
      const char* const value = std::getenv(name);
      before_.emplace_back(name,
                           value == nullptr ? std::nullopt : std::optional{std::string{value}});
    }
  }

  ChangedEnvironment(const ChangedEnvironment&) = delete;
  ChangedEnvironment& operator=(const ChangedEnvironment&) = delete;
  ChangedEnvironment(ChangedEnvironment&&) = delete;
  ChangedEnvironment& operator=(ChangedEnvironment&&) = delete;

  ~ChangedEnvironment() {
    for (const auto& [name, value] : before_) set(name, value ? value->c_str() : nullptr);
  }

  static void set(const char* name, const char* value) {
    if (value == nullptr) {
      ::unsetenv(name);
    } else {
      ::setenv(name, value, 1);
    }
  }

 private:
  std::vector<std::pair<const char*, std::optional<std::string>>> before_;
};

TEST(FilmCacheFolder, IsWhereTheUserWantsIt) {
  const ChangedEnvironment environment;
  const auto& set = ChangedEnvironment::set;
  set("HOME", "/home/anna");
  set("XDG_CACHE_HOME", nullptr);
  set("BIMODAL_CACHE", nullptr);
  EXPECT_EQ(film_cache_folder(), "/home/anna/.cache/bimodal/films");
  set("XDG_CACHE_HOME", "/cache");
  EXPECT_EQ(film_cache_folder(), "/cache/bimodal/films");
  set("BIMODAL_CACHE", "/mine");
  EXPECT_EQ(film_cache_folder(), "/mine/films");
  set("BIMODAL_CACHE", "");
  EXPECT_EQ(film_cache_folder(), std::nullopt);
}

TEST(FilmKey, DiffersIfAnythingDiffers) {
  const std::vector<TimedSegment> said{{.segment = Phone::S, .start = 0ms, .duration = 100ms},
                                       {.segment = Phone::UW, .start = 100ms, .duration = 90ms}};
  auto later = said;
  later.back().duration = Milliseconds{90.000001};
  auto other = said;
  other.front().segment = Segment{Phone::S, Phone::SH, 3, 8};
  const auto key = [&](const std::function<void(FilmOrigin&)>& change) {
    FilmOrigin origin{.drawing = "this program",
                      .articulation = said,
                      .table_sha256 = "english",
                      .look = {.height = 720, .lines = 720},
                      .layout = {.recording = 190ms, .lead = 500ms, .trail = 500ms},
                      .drawing_rate = Hertz{60}};
    change(origin);
    return film_key(origin);
  };
  const auto usual = key([](FilmOrigin&) {});
  EXPECT_EQ(usual, key([](FilmOrigin&) {}));
  const std::vector<std::function<void(FilmOrigin&)>> changes{
      [](auto& it) { it.drawing = "another"; },
      [&](auto& it) { it.articulation = later; },
      [&](auto& it) { it.articulation = other; },
      [](auto& it) { it.articulation = it.articulation.subspan(1); },
      [](auto& it) { it.table_sha256 = "turkish"; },
      [](auto& it) { it.account = Account::LookAhead; },
      [](auto& it) { it.look.height = 360; },
      [](auto& it) { it.look.lines = 360; },
      [](auto& it) { it.look.frame_rate = Hertz{25}; },
      [](auto& it) { it.look.blur_px = 1; },
      [](auto& it) { it.look.background = 1; },
      [](auto& it) { it.look.face.view = "side"; },
      [](auto& it) { it.look.face.material = "clay"; },
      [](auto& it) { it.look.face.show = {"lips"}; },
      [](auto& it) { it.look.face.hide = {"tongue"}; },
      [](auto& it) { it.look.face.transparency = 0.5; },
      [](auto& it) { it.look.face.points = "lips"; },
      [](auto& it) { it.look.face.expression["smile"] = 0.5; },
      [](auto& it) { it.look.face.expression["smile"] = 0.50001; },
      [](auto& it) { it.look.face.controls["gaze_x"] = 0.5; },
      [](auto& it) { it.quality = synth::Quality::Full; },
      [](auto& it) { it.layout.recording = 191ms; },
      [](auto& it) { it.layout.lead = 501ms; },
      [](auto& it) { it.layout.trail = 501ms; },
      [](auto& it) { it.layout.sound_lead = 1ms; },
      [](auto& it) { it.layout.av_offset = 1ms; },
      [](auto& it) { it.layout.has_sound = true; },
      [](auto& it) { it.drawing_rate = Hertz{59.94}; },
      [](auto& it) { it.cut = Cut{.at = 100ms, .blank = true}; },
      [](auto& it) { it.cut = Cut{.at = 100ms, .blank = false}; }};
  std::vector<std::string> keys{usual};
  for (const auto& change : changes) keys.push_back(key(change));
  std::ranges::sort(keys);
  EXPECT_EQ(std::ranges::adjacent_find(keys), keys.end());
}

TEST_F(FilmCaches, LetAStudioShowWhatAnotherHasDrawn) {
  protocols::Condition condition;
  condition.visual_talker = "face";
  condition.articulating.segments = "english";
  protocols::Window window;
  window.face_height = 72;
  const std::map<std::string, Corpus> no_corpora;
  Enactment enactment;
  enactment.length = 200ms;
  enactment.articulation = {{.segment = Phone::AA, .start = 0ms, .duration = 200ms}};
  const StimulusLayout layout{.recording = 200ms, .lead = 50ms, .trail = 50ms};
  const auto made = [&](std::optional<FilmCache> cache) {
    FilmStudio studio{window, no_corpora, synth::Quality::Fast, std::move(cache)};
    return studio.film(condition, enactment, layout, Hertz{30}, kNoRest);
  };
  const auto drawn = made(std::nullopt);
  EXPECT_TRUE(equal(made(FilmCache{folder()}), drawn));
  ASSERT_EQ(kept(), 1U);
  EXPECT_TRUE(equal(made(FilmCache{folder()}), drawn));
  EXPECT_EQ(kept(), 1U);
  const auto file = fs::directory_iterator {
    folder()
    } -> path();
  fs::resize_file(file, fs::file_size(file) / 2);
  EXPECT_TRUE(equal(made(FilmCache{folder()}), drawn));  // drawn anew, and kept anew
  EXPECT_EQ(kept(), 1U);
}

TEST_F(FilmCaches, KeepFacesThatLookDifferentApart) {
  protocols::Window window;
  window.face_height = 72;
  const std::map<std::string, Corpus> no_corpora;
  Enactment enactment;
  enactment.length = 200ms;
  enactment.articulation = {{.segment = Phone::AA, .start = 0ms, .duration = 200ms}};
  const StimulusLayout layout{.recording = 200ms};
  FilmStudio studio{window, no_corpora, synth::Quality::Fast, FilmCache{folder()}};
  const auto made = [&](const std::string& name, const protocols::Face& face) {
    protocols::Condition condition{.name = name, .visual_talker = "face", .face = face};
    return studio.film(condition, enactment, layout, Hertz{10}, kNoRest);
  };
  const auto whole = made("whole", {});
  EXPECT_TRUE(equal(made("also whole", {}), whole));
  ASSERT_EQ(kept(), 1U);
  const std::vector<protocols::Face> others{{.view = "mouth"},
                                            {.material = "clay"},
                                            {.hide = {"tongue"}},
                                            {.transparency = 0.6},
                                            {.points = "sparse"},
                                            {.expression = {{"smile", 1.0}}},
                                            {.controls = {{"head_yaw", 20.0}}}};
  for (std::size_t i = 0; i < others.size(); ++i) {
    EXPECT_FALSE(equal(made(std::to_string(i), others[i]), whole)) << i;
    EXPECT_EQ(kept(), i + 2);
  }
}

}  // namespace
}  // namespace bimodal::runner
