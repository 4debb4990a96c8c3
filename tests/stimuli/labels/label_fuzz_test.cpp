// Damaged files become labels or an error with the file's name, never anything else.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/labels/label_file.hpp"
#include "tests/stimuli/labels/label_cases.hpp"
#include "tests/support/damage.hpp"

namespace bimodal {
namespace {

using ::testing::StartsWith;

constexpr int kMutations = 20'000;

void damage_and_read(const std::string& valid, const std::string& name, std::uint32_t seed) {
  const auto whole = parse_labels(valid, name);
  ASSERT_FALSE(whole.tiers.empty());
  Damage damage{seed};
  int accepted = 0;
  for (int i = 0; i < kMutations; ++i) {
    const auto bytes = damage(valid);
    try {
      const auto labels = parse_labels(bytes, name);
      ++accepted;
      for (const auto& tier : labels.tiers) {
        Duration reached{};
        for (const auto& label : tier.labels) {
          ASSERT_GE(label.start, reached);
          ASSERT_GE(label.end, label.start);
          ASSERT_LE(label.end, labels.end);
          reached = label.end;
        }
        try {
          const auto utterance = utterance_of(tier, labels.end);
          ASSERT_EQ(utterance.end(), labels.end);
        } catch (const Error&) {  // words, for instance
        }
      }
    } catch (const Error& error) {
      ASSERT_THAT(error.what(), StartsWith(name + ":"));
    }
  }
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, kMutations);
}

constexpr std::string_view kGrid =
    "File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n\nxmin = 0 \nxmax = 1.5 \n"
    "tiers? <exists> \nsize = 2 \nitem []: \n    item [1]:\n        class = \"IntervalTier\" \n"
    "        name = \"phones\" \n        xmin = 0 \n        xmax = 1.5 \n"
    "        intervals: size = 2 \n        intervals [1]:\n            xmin = 0 \n"
    "            xmax = 0.5 \n            text = \"bcl\" \n        intervals [2]:\n"
    "            xmin = 0.5 \n            xmax = 1.5 \n            text = \"el\" \n"
    "    item [2]:\n        class = \"TextTier\" \n        name = \"p\" \n        xmin = 0 \n"
    "        xmax = 1.5 \n        points: size = 1 \n        points [1]:\n"
    "            number = 0.25 \n            mark = \"q\" \n";

TEST(LabelFuzz, DamagedTextGridsAreLabelsOrErrors) {
  damage_and_read(std::string{kGrid}, "x.TextGrid", 1);
}

TEST(LabelFuzz, DamagedUtf16IsLabelsOrErrors) {
  const std::u16string units(kGrid.begin(), kGrid.end());
  damage_and_read(label_cases::utf16(units, false), "x.TextGrid", 2);
  damage_and_read(label_cases::utf16(units, true), "x.TextGrid", 3);
}

TEST(LabelFuzz, DamagedHtkFilesAreLabelsOrErrors) {
  damage_and_read(
      "0 2300000 sil\n2300000 3100001 k -212.5\n3100001 4000000 \"two \\\"words\\\"\"\n"
      "4000000 5000000 it\\'s\n5000000 6000000 \\303\\244\n",
      "x.lab",
      4);
}

TEST(LabelFuzz, DamagedFestivalFilesAreLabelsOrErrors) {
  damage_and_read(
      "separator ;\nnfields 1\n#\n 0.22 26 pau ; 1\n 0.31 100 hh\n 0.5 121 ax\n", "x.lab", 5);
}

TEST(LabelFuzz, DamagedAlignFilesAreLabelsOrErrors) {
  damage_and_read("0 23750 sil\n23750 29500 bin\n29500 34000 blue\n", "x.align", 6);
}

TEST(LabelFuzz, DamagedCsvFilesAreLabelsOrErrors) {
  damage_and_read(
      "tier,start_s,end_s,text\nwords,0.0,1.0,\"a, \"\"b\"\"\"\nphones,0.25,0.5,K\r\n"
      "words,1.0,2.0,\"two\nlines\"\n",
      "x.csv",
      7);
}

}  // namespace
}  // namespace bimodal
