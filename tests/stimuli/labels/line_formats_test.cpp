// .lab, .align and .csv

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/labels/label_file.hpp"
#include "tests/stimuli/labels/label_cases.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;
using label_cases::fault_of;
using label_cases::replaced;
using ::testing::AllOf;
using ::testing::HasSubstr;

Labels one_tier(std::string name, std::vector<Label> labels) {
  const Duration end = labels.back().end;
  return {.end = end, .tiers = {{.name = std::move(name), .labels = std::move(labels)}}};
}

TEST(HtkLab, IsReadIn100Nanoseconds) {
  const std::string text =
      "0 2300000 sil\n2300000 3100001 k -212.5\n\n3100001\t4000000 ae -3 word -7\n";
  const auto expected = one_tier(
      "phones", {{0ms, 230ms, "sil"}, {230ms, 310'000'100ns, "k"}, {310'000'100ns, 400ms, "ae"}});
  EXPECT_EQ(parse_labels(text, "a.lab"), expected);
  EXPECT_EQ(parse_labels(replaced(text, "\n", "\r\n"), "a.LAB"), expected);
  EXPECT_EQ(parse_labels("\xEF\xBB\xBF" + text, "a.lab"), expected);
}

TEST(HtkLab, HasQuotedNamesAndEscapes) {
  const auto labels = parse_labels(
      "0 10 \"two words\" -3\n10 20 it\\'s\n20 30 'say \"hi\"'\n30 40 \\303\\244h\n40 50 'em\n",
      "a.lab");
  std::vector<std::string> texts;
  for (const auto& label : labels.tiers.at(0).labels) texts.push_back(label.text);
  EXPECT_EQ(texts,
            (std::vector<std::string>{"two words", "it's", "say \"hi\"", "\xC3\xA4h", "'em"}));
  EXPECT_EQ(labels.tiers.at(0).name, "words");
}

TEST(HtkLab, IsWrittenAsHtkReadsIt) {
  const WrittenFiles folder;
  write_labels(folder / "b.lab",
               one_tier("words",
                        {{0ms, 230ms, "sil"},
                         {230ms, 231'000'049ns, "two words"},
                         {231'000'050ns, 1s, "it's \\ \"x\""}}));
  EXPECT_EQ(read_file(folder / "b.lab"),
            "0 2300000 sil\n2300000 2310000 \"two words\"\n"
            "2310001 10000000 \"it's \\\\ \\\"x\\\"\"\n");
}

TEST(HtkLab, RefusesWhatIsWrongWithItsLine) {
  EXPECT_EQ(
      fault_of("0 100 a\nsil\n", "c.lab"),
      "c.lab:2: \"sil\" has no start and end; write start, end (both in 100 ns) and label, or "
      "give a file with times");
  EXPECT_THAT(fault_of("100 sil\n", "c.lab"), HasSubstr("c.lab:1: \"100\" has no start and end"));
  EXPECT_THAT(fault_of("0 100\n", "c.lab"), HasSubstr("c.lab:1: there is no label"));
  EXPECT_THAT(fault_of("0 100 a\n50 200 b", "c.lab"), HasSubstr("c.lab:2: the label \"b\" begins"));
  EXPECT_THAT(fault_of("200 100 a", "c.lab"), HasSubstr("c.lab:1: the label \"a\" begins"));
  EXPECT_THAT(fault_of("-90 100 a", "c.lab"), HasSubstr("c.lab:1: the time \"-90\" is negative"));
  EXPECT_THAT(fault_of("x 100 a", "c.lab"), HasSubstr("c.lab:1: \"x\" is not a time in units"));
  EXPECT_THAT(fault_of("0.25 100 pau", "c.lab"),
              AllOf(HasSubstr("c.lab:1: \"0.25\" is not a time"), HasSubstr("\"#\"")));
  EXPECT_THAT(fault_of("0 1 a\n///\n0 1 b\n", "c.lab"), HasSubstr("c.lab:2: "));
  EXPECT_THAT(fault_of("#!MLF!#\n\"*/a.lab\"\n0 1 a\n.\n", "c.lab"),
              HasSubstr("c.lab:1: this is a master label file"));
  EXPECT_THAT(fault_of("0 1 \\377\n", "c.lab"), HasSubstr("c.lab:1: the escapes"));
  EXPECT_THAT(fault_of("", "c.lab"), HasSubstr("c.lab: there is no label in it"));
}

TEST(FestivalLab, BeginsEachLabelWhereTheOneBeforeItEnds) {
  const std::string text =
      "separator ;\nnfields 1\n#\n    0.2200 26 \tpau ; score 1\n 0.31 100 hh\n0.5 121 ax-h\n";
  const auto expected =
      one_tier("phones", {{0ms, 220ms, "pau"}, {220ms, 310ms, "hh"}, {310ms, 500ms, "ax-h"}});
  EXPECT_EQ(parse_labels(text, "a.lab"), expected);
  EXPECT_EQ(parse_labels(replaced(text, "\n", "\r\n"), "a.lab"), expected);
  EXPECT_EQ(parse_labels("#\n0.5 100 two words\n", "a.lab"),
            one_tier("words", {{0ms, 500ms, "two words"}}));
}

TEST(FestivalLab, OfFestivalItselfIsAnUtterance) {
  if (std::system("command -v festival >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "festival is not installed";
  }
  const WrittenFiles folder;
  const auto lab = (folder / "f.lab").string();
  const auto script = folder.write(
      "say.scm", "(utt.save.segs (utt.synth (Utterance Phones (pau k ae t pau))) \"" + lab + "\")");
  const auto command = "festival -b '" + script.string() + "' >/dev/null 2>&1";
  if (std::system(command.c_str()) != 0) GTEST_SKIP() << "festival has no voice";
  const auto labels = read_labels(lab);
  std::string said;
  for (const auto& timed : utterance_of(*phone_tier(labels), labels.end).phones) {
    said += std::string{symbol(timed.phone)} + " ";
  }
  EXPECT_EQ(said, "rest K AE T rest ");
}

TEST(FestivalLab, RefusesWhatIsWrongWithItsLine) {
  EXPECT_THAT(fault_of("#\n0.5 100 a\n0.4 100 b\n", "d.lab"), HasSubstr("d.lab:3: "));
  EXPECT_THAT(fault_of("#\n0.5 pau\n", "d.lab"), HasSubstr("d.lab:2: \"0.5\" is not followed by"));
  EXPECT_THAT(fault_of("#\n0.5 100\n", "d.lab"), HasSubstr("d.lab:2: \"0.5\" is not followed by"));
  EXPECT_THAT(fault_of("#\nnan 100 a\n", "d.lab"), HasSubstr("d.lab:2: \"nan\" is not a time"));
  EXPECT_THAT(fault_of("#\n", "d.lab"), HasSubstr("d.lab: there is no label in it"));
}

TEST(Align, Has25000UnitsToTheSecond) {
  const std::string text = "0 23750 sil\n23750 29500 bin\n29500 34000 blue\n";
  const auto expected =
      one_tier("words", {{0ms, 950ms, "sil"}, {950ms, 1180ms, "bin"}, {1180ms, 1360ms, "blue"}});
  EXPECT_EQ(parse_labels(text, "a.align"), expected);
  EXPECT_EQ(parse_labels(replaced(text, "\n", "\r\n"), "a.align"), expected);
  const WrittenFiles folder;
  write_labels(folder / "b.align", expected);
  EXPECT_EQ(read_file(folder / "b.align"), text);
}

TEST(Align, RefusesWhatIsWrongWithItsLine) {
  EXPECT_THAT(fault_of("0 100 a\n100 200\n", "e.align"),
              HasSubstr("e.align:2: \"100\" is not followed by end and word"));
  EXPECT_THAT(fault_of("0 1.5 a\n", "e.align"), HasSubstr("e.align:1: \"1.5\" is not a time"));
  EXPECT_THAT(fault_of("0 100 a\n90 200 b\n", "e.align"), HasSubstr("e.align:2: the label \"b\""));
  EXPECT_THAT(fault_of("0 99999999999 a\n", "e.align"), HasSubstr("beyond 1000000 s"));
  EXPECT_THAT(fault_of("\n\n", "e.align"), HasSubstr("e.align: there is no label in it"));
}

TEST(Align, OfTheCorpusIsRead) {
  const char* const folder = std::getenv("BIMODAL_TEST_DATA");
  if (folder == nullptr) GTEST_SKIP() << "BIMODAL_TEST_DATA is not set";
  const auto file = std::filesystem::path{folder} / "clips" / "bbaf2n.align";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const auto labels = read_labels(file);
  EXPECT_EQ(labels.end, 2980ms);
  EXPECT_EQ(word_tier(labels)->labels.at(1), (Label{950ms, 1180ms, "bin"}));
}

TEST(CsvLabels, HaveTheirColumnsInAnyOrder) {
  EXPECT_EQ(parse_labels("start_s,end_s,text\n0,0.25,sil\n0.25,1.5,AH0\n", "a.csv"),
            one_tier("phones", {{0ms, 250ms, "sil"}, {250ms, 1500ms, "AH0"}}));
  EXPECT_EQ(
      parse_labels("text,note,end_s,tier,start_s\r\n"
                   "\"a, \"\"b\"\"\",x,1,words,0\r\n"
                   "K,,0.5,phones,0.25\r\n"
                   "\"two\r\nlines\",\"\", 2 ,words, 1e0\r\n"
                   ",,3,words,2",
                   "a.csv"),
      (Labels{.end = 3s,
              .tiers = {{.name = "words", .labels = {{0s, 1s, "a, \"b\""}, {1s, 2s, "two\nlines"}}},
                        {.name = "phones", .labels = {{250ms, 500ms, "K"}}}}}));
}

TEST(CsvLabels, KeepTiersWithoutLabelsAndTheEnd) {
  const WrittenFiles folder;
  const Labels labels{
      .end = 2s,
      .tiers = {{.name = "none", .labels = {}}, {.name = "a,b", .labels = {{0s, 1s, "x"}}}}};
  write_labels(folder / "b.csv", labels);
  EXPECT_EQ(read_file(folder / "b.csv"),
            "tier,start_s,end_s,text\nnone,0.0,2.0,\n\"a,b\",0.0,1.0,x\n\"a,b\",1.0,2.0,\n");
  EXPECT_EQ(read_labels(folder / "b.csv"), labels);
}

TEST(CsvLabels, RefuseWhatIsWrongWithItsLine) {
  const auto fault = [](const std::string& rows) {
    return fault_of("start_s,end_s,text\n" + rows, "f.csv");
  };
  EXPECT_THAT(fault("0,1\n"), HasSubstr("f.csv:2: 2 fields, but the first line has 3"));
  EXPECT_THAT(fault("0,1,\"a\nb\"\n2,x,c\n"), HasSubstr("f.csv:4: \"x\" is not a time"));
  EXPECT_THAT(fault("0,1,a\n0.5,2,b\n"), HasSubstr("f.csv:3: the label \"b\" begins at 0.5 s"));
  EXPECT_THAT(fault("0,1,\"a\n"), HasSubstr("f.csv:2: the quoted field that begins here"));
  EXPECT_THAT(fault("0,1,\"a\"b\n"), HasSubstr("f.csv:2: \"a\" goes on"));
  EXPECT_THAT(fault("0,1,a\"b\n"), HasSubstr("f.csv:2: a quotation mark within"));
  EXPECT_THAT(fault_of("start_s;end_s;text\n0;1;a\n", "f.csv"),
              AllOf(HasSubstr("f.csv:1: there is no column \"start_s\""), HasSubstr("commas")));
  EXPECT_THAT(fault(std::string(1'000, ',')), HasSubstr("f.csv:2: more than 1000 fields"));
  EXPECT_THAT(fault_of("", "f.csv"), HasSubstr("f.csv: the file is empty"));
}

}  // namespace
}  // namespace bimodal
