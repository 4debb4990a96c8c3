#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/observers/observer_description.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/digest.hpp"

namespace bimodal::protocols {
namespace {

using enum Phone;
using nlohmann::json;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::filesystem::path typical_file() {
  return asset("protocols/observers/typical.json");
}

json typical_json() {
  return json::parse(read_file(typical_file()));
}

std::vector<std::string> messages_about(const std::string& text) {
  const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto file = std::filesystem::path{::testing::TempDir()} /
                    (std::string{"bimodal-observer-"} + test->name() + ".json");
  std::ofstream{file} << text;
  std::vector<Diagnostic> diagnostics;
  (void)read_observer(file, diagnostics);
  std::vector<std::string> messages;
  for (const auto& diagnostic : diagnostics) messages.push_back(describe(diagnostic));
  return messages;
}

std::vector<std::string> messages_about(const json& value) {
  return messages_about(value.dump(1));
}

TEST(ReadObserver, TheTypicalOneSaysThatItWasNotMeasured) {
  std::vector<Diagnostic> diagnostics;
  const auto observer = read_observer(typical_file(), diagnostics);
  EXPECT_THAT(diagnostics, IsEmpty());
  EXPECT_EQ(observer.name, "typical");
  EXPECT_THAT(observer.provenance, HasSubstr("chosen by us, plausible, not measured"));
  EXPECT_EQ(observer.stated_snr, Decibels{-8});
  for (const Phone phone : all_phones().subspan(1)) {
    EXPECT_NEAR(observer.auditory.row_sum(phone), 1.0, 1e-12);
    EXPECT_NEAR(observer.visual.row_sum(phone), 1.0, 1e-12);
  }
}

TEST(ReadObserver, TheTypicalOneHearsVoicingBetterThanPlaceAndSeesTheOtherWayRound) {
  std::vector<Diagnostic> diagnostics;
  const auto observer = read_observer(typical_file(), diagnostics);
  EXPECT_GT(observer.auditory(P, T), observer.auditory(P, B));
  EXPECT_GT(observer.auditory(M, N), observer.auditory(M, B));
  EXPECT_GT(observer.visual(P, B), 10 * observer.visual(P, T));
  EXPECT_GT(observer.visual(F, V), 10 * observer.visual(F, P));
  // a viseme class is recognised as a class
  EXPECT_GT(observer.visual(P, P) + observer.visual(P, B) + observer.visual(P, M), 0.75);
}

TEST(ReadObserver, TheToolWritesTheTypicalOneAgain) {
  const auto file = std::filesystem::path{::testing::TempDir()} / "bimodal-typical.json";
  const std::string command = "python3 -B '" + asset("tools/observers/make_typical.py").string() +
                              "' '" + file.string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(sha256_of_file(file), sha256_of_file(typical_file()));
}

TEST(ReadObserver, NamesARowThatDoesNotSumToOne) {
  auto observer = typical_json();
  observer["visual"]["vowels"]["rows"]["IY"][3] = 0.5;
  EXPECT_THAT(messages_about(observer),
              ElementsAre(HasSubstr("/visual/vowels/rows/IY: the row sums to 1.")));
}

TEST(ReadObserver, ReportsAllMistakesAtOnce) {
  auto observer = typical_json();
  observer.erase("name");
  observer["provenance"] = 3;
  observer["stated_snr_db"] = "loud";
  observer["slope_per_db"] = 0;
  observer["surplus"] = 1;
  auto& consonants = observer["auditory"]["consonants"]["rows"];
  consonants.erase("ZH");
  consonants["QQ"] = consonants["P"];
  consonants["AA"] = consonants["P"];
  consonants["B"].erase(0);
  consonants["M"][2] = -1;
  consonants["T"] = "flat";
  observer["visual"].erase("vowels");
  const auto messages = messages_about(observer);
  EXPECT_EQ(messages.size(), 12U) << ::testing::PrintToString(messages);
  for (const auto* const part :
       {"there is no \"name\"",
        "/provenance: 3 is no text",
        "/stated_snr_db: \"loud\" is not a number; give the S/N",
        "/slope_per_db: 0 is not above 0",
        "/surplus: warning: nothing reads \"surplus\"",
        "/auditory/consonants/rows: there is no row for ZH",
        "/auditory/consonants/rows/QQ: \"QQ\" is no consonant; use each of P B M",
        "/auditory/consonants/rows/AA: \"AA\" is no consonant",
        "/auditory/consonants/rows/B: there are 24 numbers; give an array of 25",
        "/auditory/consonants/rows/M/2: -1 is no probability",
        "/auditory/consonants/rows/T: \"flat\" is no row",
        "/visual: there is no \"vowels\""}) {
    EXPECT_THAT(messages, Contains(HasSubstr(part)));
  }
}

TEST(ReadObserver, WantsEachPhoneOnceAmongTheColumns) {
  auto observer = typical_json();
  observer["visual"]["consonants"]["columns"][1] = "P";
  EXPECT_THAT(
      messages_about(observer),
      ElementsAre(HasSubstr("/visual/consonants/columns: there is no column for B"),
                  HasSubstr("/visual/consonants/columns: there are several columns for P")));
}

TEST(ReadObserver, WantsEachPhoneRecognisedSometimes) {
  auto observer = typical_json();
  auto& row = observer["visual"]["vowels"]["rows"]["IY"];
  row[1] = row[1].get<double>() + row[0].get<double>();
  row[0] = 0;
  EXPECT_THAT(messages_about(observer),
              ElementsAre(HasSubstr("/visual/vowels/rows/IY: IY is never recognised")));
}

TEST(ReadObserver, ReportsWhatIsNoObserver) {
  EXPECT_THAT(messages_about(std::string{"{\n\"name\": }"}),
              ElementsAre(HasSubstr(":2: not JSON")));
  EXPECT_THAT(messages_about(json::array()), ElementsAre(HasSubstr("must be an object")));
}

}  // namespace
}  // namespace bimodal::protocols
