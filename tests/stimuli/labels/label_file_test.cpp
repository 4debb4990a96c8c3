// What holds for every format.

#include "stimuli/labels/label_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/digest.hpp"
#include "tests/stimuli/labels/label_cases.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;
using label_cases::fault_of;
using label_cases::message_of;
using label_cases::random_labels;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr int kTries = 300;

/// Written and read again.
Labels there_and_back(const WrittenFiles& folder, const std::string& name, const Labels& labels) {
  write_labels(folder / name, labels);
  return read_labels(folder / name);
}

Labels rounded(Labels labels, Duration unit) {
  const auto round = [&](Duration& time) { time = (time + unit / 2) / unit * unit; };
  round(labels.end);
  for (auto& tier : labels.tiers) {
    for (auto& label : tier.labels) {
      round(label.start);
      round(label.end);
    }
  }
  return labels;
}

TEST(LabelFile, GivesATextGridBackToTheNanosecond) {
  const WrittenFiles folder;
  Random random{1};
  for (int i = 0; i < kTries; ++i) {
    auto labels = random_labels(random, {});
    labels.end += std::chrono::nanoseconds{random.below(2) * random.below(1'000'000'000)};
    if (i % 5 == 0) labels.tiers.push_back({.name = labels.tiers.front().name, .labels = {}});
    ASSERT_EQ(there_and_back(folder, "a.TextGrid", labels), labels) << i;
  }
}

TEST(LabelFile, GivesACsvBackToTheNanosecond) {
  const WrittenFiles folder;
  Random random{2};
  for (int i = 0; i < kTries; ++i) {
    auto labels = random_labels(random, {});
    labels.end += std::chrono::nanoseconds{random.below(2) * random.below(1'000'000'000)};
    if (i % 5 == 0) labels.tiers.push_back({.name = "none", .labels = {}});
    ASSERT_EQ(there_and_back(folder, "a.csv", labels), labels) << i;
  }
}

TEST(LabelFile, GivesAnHtkFileBackToItsUnit) {
  const WrittenFiles folder;
  Random random{3};
  for (int i = 0; i < kTries; ++i) {
    auto labels = random_labels(random, {.grid = Duration{i % 2 == 0 ? 100 : 1}, .tiers = 1});
    const auto back = there_and_back(folder, "a.lab", labels);
    labels.tiers.front().name = back.tiers.front().name;
    auto expected = rounded(labels, Duration{100});
    ASSERT_EQ(back, expected) << i;
  }
}

TEST(LabelFile, GivesAnAlignFileBackToItsUnit) {
  const WrittenFiles folder;
  Random random{4};
  for (int i = 0; i < kTries; ++i) {
    auto labels = random_labels(
        random, {.grid = Duration{i % 2 == 0 ? 40'000 : 1}, .line_breaks = false, .tiers = 1});
    labels.tiers.front().name = "words";
    ASSERT_EQ(there_and_back(folder, "a.align", labels), rounded(labels, 40us)) << i;
  }
}

TEST(LabelFile, TakesLabelsWithoutTextForGaps) {
  const WrittenFiles folder;
  const Labels labels{.end = 3s,
                      .tiers = {{.name = "words", .labels = {{1s, 2s, "a"}, {2s, 3s, ""}}}}};
  auto without = labels;
  without.tiers.front().labels.pop_back();
  EXPECT_EQ(there_and_back(folder, "a.TextGrid", labels), without);
  EXPECT_EQ(there_and_back(folder, "a.csv", labels), without);
  without.end = 2s;
  without.tiers.front().name = "words";
  EXPECT_EQ(there_and_back(folder, "a.align", labels), without);
  EXPECT_EQ(there_and_back(folder, "a.lab", labels), without);
}

TEST(LabelFile, KeepsPointsWithoutText) {
  const WrittenFiles folder;
  const Labels labels{.end = 3s, .tiers = {{.name = "phones", .labels = {{1s, 1s, ""}}}}};
  EXPECT_EQ(there_and_back(folder, "a.TextGrid", labels), labels);
  EXPECT_EQ(there_and_back(folder, "a.csv", labels), labels);
}

TEST(LabelFile, ReplacesWhatWasThereAndLeavesNoDraft) {
  const WrittenFiles folder;
  const Labels labels{.end = 1s, .tiers = {{.name = "words", .labels = {{0s, 1s, "a"}}}}};
  write_labels(folder.write("a.csv", "something else"), labels);
  EXPECT_EQ(read_labels(folder / "a.csv"), labels);
  const std::filesystem::directory_iterator files{(folder / "a.csv").parent_path()};
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
  EXPECT_THAT(message_of([&] { write_labels(folder / "no/such/b.csv", labels); }),
              AllOf(HasSubstr("cannot write"), HasSubstr("no/such/b.csv")));
}

TEST(LabelFile, RefusesLabelsThatDoNotKeepTheirPromises) {
  const WrittenFiles folder;
  const auto fault = [&](std::vector<Label> labels, Duration end) {
    return message_of([&] {
      write_labels(folder / "a.TextGrid",
                   {.end = end, .tiers = {{.name = "t", .labels = std::move(labels)}}});
    });
  };
  EXPECT_THAT(fault({{0s, 2s, "a"}, {1s, 3s, "b"}}, 3s), HasSubstr("tier \"t\": the label \"b\""));
  EXPECT_THAT(fault({{2s, 1s, "a"}}, 3s), HasSubstr("out of order"));
  EXPECT_THAT(fault({{-1s, 1s, "a"}}, 3s), HasSubstr("out of order"));
  EXPECT_THAT(fault({{0s, 4s, "a"}}, 3s), HasSubstr("beyond the end"));
  EXPECT_THAT(fault({{0s, 1s, " a"}}, 3s), HasSubstr("blanks"));
  EXPECT_THAT(fault({{0s, 1s, "\xFF"}}, 3s), HasSubstr("UTF-8"));
  EXPECT_THAT(fault({{0s, 1s, std::string("a\0b", 3)}}, 3s), HasSubstr("UTF-8"));
  EXPECT_THAT(fault({}, 2'000'000s), HasSubstr("2000000.0 s"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.TextGrid"));
}

TEST(LabelFile, RefusesWhatAFormatCannotHold) {
  const WrittenFiles folder;
  const auto fault = [&](const std::string& name, const std::vector<Tier>& tiers) {
    return message_of([&] { write_labels(folder / name, {.end = 1s, .tiers = tiers}); });
  };
  const Tier none{.name = "t", .labels = {}};
  EXPECT_THAT(fault("a.lab", {}), HasSubstr("there is no tier"));
  EXPECT_THAT(fault("a.lab", {none}), HasSubstr("the tier \"t\" has no labels"));
  EXPECT_THAT(fault("a.align", {none}), HasSubstr("the tier \"t\" has no labels"));
  EXPECT_THAT(fault("a.align", {{.name = "t", .labels = {{0s, 1s, "a\nb"}}}}),
              HasSubstr("is not one line of text"));
  EXPECT_THAT(fault("a.csv", {none, none}), HasSubstr("two tiers are called \"t\""));
}

TEST(LabelFile, KnowsFormatsByTheirEndings) {
  for (const auto* const name : {"a.wav", "a", ".lab", "", "TextGrid"}) {
    EXPECT_THAT(fault_of("0 1 a", name), HasSubstr(".TextGrid, .lab, .align or .csv")) << name;
  }
  EXPECT_THAT(message_of([] { write_labels("a.txt", {}); }), HasSubstr("a.txt"));
  EXPECT_TRUE(holds_one_tier("a.LAB"));
  EXPECT_TRUE(holds_one_tier("b/a.align"));
  EXPECT_FALSE(holds_one_tier("a.lab.TextGrid"));
  EXPECT_FALSE(holds_one_tier("a.csv"));
}

TEST(LabelFile, NamesTheFileThatCannotBeRead) {
  const WrittenFiles folder;
  EXPECT_THAT(message_of([&] { (void)read_labels(folder / "absent.lab"); }),
              HasSubstr("absent.lab"));
  std::filesystem::create_directory(folder / "folder.lab");
  EXPECT_THAT(message_of([&] { (void)read_labels(folder / "folder.lab"); }),
              HasSubstr("it is a folder"));
}

TEST(LabelFile, RefusesFilesThatAreTooLarge) {
  const WrittenFiles folder;
  const auto file = folder.write("a.lab", "");
  std::filesystem::resize_file(file, (16UL << 20U) + 1);
  EXPECT_THAT(message_of([&] { (void)read_labels(file); }),
              AllOf(HasSubstr("a.lab: 16777217 bytes"), HasSubstr("16 MB")));
  std::string many;
  for (int i = 0; i <= 200'000; ++i)
    many += std::to_string(i) + " " + std::to_string(i + 1) + " a\n";
  EXPECT_THAT(fault_of(many, "a.lab"), HasSubstr("a.lab:200001: more than 200000 labels"));
}

}  // namespace
}  // namespace bimodal
