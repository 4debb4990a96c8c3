// Praat itself reads what we write, and we read what Praat writes.

#include <cstdlib>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/labels/label_file.hpp"
#include "tests/stimuli/labels/label_cases.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

bool has_praat() {
  return std::system("command -v praat >/dev/null 2>&1") == 0;
}

/// Runs a script and returns what it printed.
std::string run_praat(const WrittenFiles& folder, const std::string& script) {
  const auto file = folder.write("script.praat", script);
  const auto output = folder / "output.txt";
  const auto command = fmt::format(
      "praat --no-pref-files --utf8 --run '{}' >'{}' 2>&1", file.string(), output.string());
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(output);
  return read_file(output);
}

Labels sample() {
  return {.end = 1'500'000'001ns,
          .tiers = {{.name = "phones",
                     .labels = {{0ms, 123'456'789ns, "HH"},
                                {123'456'789ns, 700ms, "say \"hi\""},
                                {900ms, 1'500'000'001ns, "\xC9\x91\xCB\x90"}}},
                    {.name = "words", .labels = {{250ms, 1s, "ch\xC3\xA2teau"}}},
                    {.name = "none", .labels = {}},
                    {.name = "points", .labels = {{250ms, 250ms, "click"}, {1s, 1s, ""}}}}};
}

/// What Praat should tell about labels: a line for each interval, gaps included, and point.
std::string described(const Labels& labels) {
  std::string text;
  for (const auto& tier : labels.tiers) {
    text += tier.name + "\n";
    const bool points =
        !tier.labels.empty() && tier.labels.front().start == tier.labels.front().end;
    Duration reached{};
    const auto line = [&](Duration start, Duration end, const std::string& said) {
      const auto seconds = [](Duration time) {
        return std::chrono::duration<double>{time}.count();
      };
      text += points ? fmt::format("{:.9f} [{}]\n", seconds(start), said)
                     : fmt::format("{:.9f} {:.9f} [{}]\n", seconds(start), seconds(end), said);
    };
    for (const auto& label : tier.labels) {
      if (!points && reached < label.start) line(reached, label.start, "");
      line(label.start, label.end, label.text);
      reached = label.end;
    }
    if (!points && reached < labels.end) line(reached, labels.end, "");
  }
  return text;
}

constexpr const char* kDescribe = R"(
tiers = Get number of tiers
for tier to tiers
  name$ = Get tier name: tier
  appendInfoLine: name$
  interval = Is interval tier: tier
  if interval
    count = Get number of intervals: tier
    for i to count
      start = Get start time of interval: tier, i
      end = Get end time of interval: tier, i
      text$ = Get label of interval: tier, i
      appendInfoLine: fixed$ (start, 9), " ", fixed$ (end, 9), " [", text$, "]"
    endfor
  else
    count = Get number of points: tier
    for i to count
      time = Get time of point: tier, i
      text$ = Get label of point: tier, i
      appendInfoLine: fixed$ (time, 9), " [", text$, "]"
    endfor
  endif
endfor
)";

/// Praat writes an exact zero as "0" whatever the number of decimals.
std::string with_short_zeros(const std::string& text) {
  return label_cases::replaced(text, "0.000000000 ", "0 ");
}

TEST(Praat, ReadsOurTextGridsAsTheyAreMeant) {
  if (!has_praat()) GTEST_SKIP() << "praat is not installed";
  const WrittenFiles folder;
  write_labels(folder / "ours.TextGrid", sample());
  const auto told = run_praat(
      folder,
      fmt::format("Read from file: \"{}\"\n", (folder / "ours.TextGrid").string()) + kDescribe);
  EXPECT_EQ(told, with_short_zeros(described(sample())));
}

TEST(Praat, ReadsEveryRandomTextGrid) {
  if (!has_praat()) GTEST_SKIP() << "praat is not installed";
  const WrittenFiles folder;
  Random random{5};
  std::string script;
  std::string expected;
  for (int i = 0; i < 20; ++i) {
    const auto file = folder / fmt::format("{}.TextGrid", i);
    auto labels = label_cases::random_labels(random, {.points = false, .line_breaks = false});
    labels.end += 1s;
    write_labels(file, labels);
    script += fmt::format("Read from file: \"{}\"\n", file.string()) + kDescribe;
    expected += described(labels);
  }
  EXPECT_EQ(run_praat(folder, script), with_short_zeros(expected));
}

TEST(Praat, WritesTextGridsThatWeRead) {
  if (!has_praat()) GTEST_SKIP() << "praat is not installed";
  const WrittenFiles folder;
  write_labels(folder / "ours.TextGrid", sample());
  const auto path = [&](const char* name) { return (folder / name).string(); };
  run_praat(folder,
            fmt::format("Read from file: \"{}\"\n"
                        "Text writing preferences: \"UTF-8\"\n"
                        "Save as text file: \"{}\"\n"
                        "Save as short text file: \"{}\"\n"
                        "Save as chronological text file: \"{}\"\n"
                        "Save as binary file: \"{}\"\n"
                        "Text writing preferences: \"UTF-16\"\n"
                        "Save as text file: \"{}\"\n"
                        "Save as short text file: \"{}\"\n"
                        "Text writing preferences: \"UTF-8\"\n",
                        path("ours.TextGrid"),
                        path("long.TextGrid"),
                        path("short.TextGrid"),
                        path("chronological.TextGrid"),
                        path("binary.TextGrid"),
                        path("long16.TextGrid"),
                        path("short16.TextGrid")));
  for (const auto* const name :
       {"long.TextGrid", "short.TextGrid", "long16.TextGrid", "short16.TextGrid"}) {
    EXPECT_EQ(read_labels(folder / name), sample()) << name;
  }
  EXPECT_THAT(read_file(folder / "long16.TextGrid"), testing::StartsWith("\xFE\xFF"));
  for (const auto* const name : {"chronological.TextGrid", "binary.TextGrid"}) {
    EXPECT_THAT(label_cases::message_of([&] { (void)read_labels(folder / name); }),
                HasSubstr("'Save as text file...'"))
        << name;
  }
}

}  // namespace
}  // namespace bimodal
