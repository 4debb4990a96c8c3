#include "analysis/scoring/spelling.hpp"

#include <gtest/gtest.h>

namespace bimodal::analysis {
namespace {

struct Example {
  std::string typed;
  std::string folded;
};

class FoldSpelling : public testing::TestWithParam<Example> {};

TEST_P(FoldSpelling, KeepsOnlyWhatTellsWordsApart) {
  EXPECT_EQ(fold_spelling(GetParam().typed), GetParam().folded);
}

INSTANTIATE_TEST_SUITE_P(Examples,
                         FoldSpelling,
                         testing::Values(Example{"stew", "stew"},
                                         Example{"  Stew\t", "stew"},
                                         Example{"STEW.", "stew"},
                                         Example{"s t ew", "stew"},
                                         Example{"\"stew\"?!", "stew"},
                                         Example{"\xc2\xa0stew\xe2\x80\x8b\xef\xbb\xbf", "stew"},
                                         Example{"ice-cream", "icecream"},
                                         Example{"ice\xe2\x80\x91"
                                                 "cream",
                                                 "icecream"},
                                         Example{"", ""},
                                         Example{" ?! \xe2\x80\xa6 ", ""},
                                         Example{"'", ""},
                                         Example{"can't", "can't"},
                                         Example{"can\xe2\x80\x99t", "can't"},
                                         Example{"can\xc2\xb4t", "can't"},
                                         Example{"'stew'", "stew"},
                                         Example{"\xe2\x80\x98stew\xe2\x80\x99", "stew"},
                                         Example{"caf\xc3\xa9", "cafe"},
                                         Example{"cafe\xcc\x81", "cafe"},
                                         Example{"CAF\xc3\x89", "cafe"},
                                         Example{"Stra\xc3\x9f"
                                                 "e",
                                                 "strasse"},
                                         Example{"\xc5\x92uvre", "oeuvre"},
                                         Example{"\xc5\x81\xc3\xb3"
                                                 "d\xc5\xba",
                                                 "lodz"},
                                         Example{"\xc4\xb0\xc5\xbe\xc5\xbf", "izs"},
                                         Example{"8", "8"},
                                         Example{"\xd1\x8f", "\xd1\x8f"},
                                         Example{"\xff\xc3", "\xff\xc3"},
                                         Example{"NA", "na"}));

}  // namespace
}  // namespace bimodal::analysis
