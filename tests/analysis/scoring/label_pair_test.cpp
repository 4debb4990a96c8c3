#include "analysis/scoring/label_pair.hpp"

#include <map>

#include <gmock/gmock.h>

#include "tests/analysis/examples.hpp"

namespace bimodal::analysis {

static void PrintTo(const LabelPair& pair, std::ostream* out) {
  *out << pair.stimulus << " > " << pair.response << " (" << pair.weight << ")";
}

namespace {

using examples::trial;
using testing::ElementsAre;
using testing::IsEmpty;

class ConfusionsOf : public testing::Test {
 protected:
  std::vector<LabelPair> confusions(Unit unit,
                                    const std::string& word,
                                    std::string_view spoken,
                                    const std::string& response,
                                    TieRule ties = TieRule::LeftOut) {
    ScoringRules rules;
    rules.ties = ties;
    const auto made = trial(word, spoken, response);
    return confusions_of(made, score(made, dictionary_, rules), unit);
  }

  std::vector<LabelPair> averaged(Unit unit,
                                  const std::string& word,
                                  std::string_view spoken,
                                  const std::string& response) {
    return confusions(unit, word, spoken, response, TieRule::Averaged);
  }

  [[nodiscard]] const Dictionary& dictionary() const { return dictionary_; }

 private:
  WrittenFiles folder_;
  Dictionary dictionary_ = examples::dictionary(folder_);
};

TEST_F(ConfusionsOf, APlaceAreItsPhoneAndWhatStandsAgainstIt) {
  EXPECT_THAT(confusions(Unit::ConsonantInitial, "bed", "B EH D", "mat"),
              ElementsAre(LabelPair{"B", "M"}));
  EXPECT_THAT(confusions(Unit::ConsonantInitial, "stew", "S T UW", "two"),
              ElementsAre(LabelPair{"S", "deleted"}));
  EXPECT_THAT(confusions(Unit::Vowel, "bed", "B EH D", ""), ElementsAre(LabelPair{"EH", "blank"}));
  EXPECT_THAT(confusions(Unit::Vowel, "bed", "B EH D", "bedd"),
              ElementsAre(LabelPair{"EH", "other"}));
  EXPECT_THAT(confusions(Unit::ConsonantFinal, "stew", "S T UW", "bat"), IsEmpty());
}

TEST_F(ConfusionsOf, AnAmbiguousPlaceAreLeftOutOrAveraged) {
  EXPECT_THAT(confusions(Unit::ConsonantInitial, "stew", "S T UW", "bee"), IsEmpty());
  EXPECT_THAT(averaged(Unit::ConsonantInitial, "stew", "S T UW", "bee"),
              ElementsAre(LabelPair{"S", "deleted", 0.5}, LabelPair{"S", "B", 0.5}));
  EXPECT_THAT(averaged(Unit::Vowel, "rid", "R IH D", "read"),
              ElementsAre(LabelPair{"IH", "IY", 0.5}, LabelPair{"IH", "EH", 0.5}));
}

TEST_F(ConfusionsOf, AnOnsetAndACodaAreWholeClusters) {
  EXPECT_THAT(confusions(Unit::Onset, "stew", "S T UW", "blow"),
              ElementsAre(LabelPair{"S T", "B L"}));
  EXPECT_THAT(confusions(Unit::Onset, "stew", "S T UW", "bee"), ElementsAre(LabelPair{"S T", "B"}));
  EXPECT_THAT(confusions(Unit::Onset, "stew", "S T UW", "ate"),
              ElementsAre(LabelPair{"S T", "none"}));
  EXPECT_THAT(confusions(Unit::Onset, "ate", "EY T", "bat"), ElementsAre(LabelPair{"none", "B"}));
  EXPECT_THAT(confusions(Unit::Coda, "bat", "B AE T", "can't"), ElementsAre(LabelPair{"T", "N T"}));
  EXPECT_THAT(confusions(Unit::Coda, "tuna", "T UW N AH", "bat"),
              ElementsAre(LabelPair{"none", "T"}));
  EXPECT_THAT(confusions(Unit::Coda, "two", "T UW", "too"), ElementsAre(LabelPair{"none", "none"}));
  EXPECT_THAT(confusions(Unit::Coda, "bat", "B AE T", " "), ElementsAre(LabelPair{"T", "blank"}));
  EXPECT_THAT(confusions(Unit::Coda, "bat", "B AE T", "xyz"), ElementsAre(LabelPair{"T", "other"}));
}

TEST_F(ConfusionsOf, AnOnsetInWhichEquallyGoodPronunciationsAgreeAreCertain) {
  EXPECT_THAT(confusions(Unit::Onset, "rid", "R IH D", "lead"), ElementsAre(LabelPair{"R", "L"}));
}

TEST_F(ConfusionsOf, PhonemesAreAllPhonesThatAreCertain) {
  EXPECT_THAT(confusions(Unit::Phoneme, "bed", "B EH D", "mat"),
              ElementsAre(LabelPair{"B", "M"}, LabelPair{"EH", "AE"}, LabelPair{"D", "T"}));
  EXPECT_THAT(confusions(Unit::Phoneme, "stew", "S T UW", "bee"),
              ElementsAre(LabelPair{"UW", "IY"}));
  EXPECT_THAT(averaged(Unit::Phoneme, "stew", "S T UW", "bee"), testing::SizeIs(5));
}

TEST_F(ConfusionsOf, WordsAreSpellings) {
  EXPECT_THAT(confusions(Unit::Word, "NA", "", "ma"), ElementsAre(LabelPair{"na", "ma"}));
  EXPECT_THAT(confusions(Unit::Word, "NA", "", "na!"), ElementsAre(LabelPair{"na", "na"}));
  EXPECT_THAT(confusions(Unit::Word, "na", "", ""), ElementsAre(LabelPair{"na", "blank"}));
  EXPECT_THAT(confusions(Unit::Word, "two", "T UW", "too"), ElementsAre(LabelPair{"two", "two"}));
}

TEST_F(ConfusionsOf, AWordThatIsSpelledAsAColumnStandsInApostrophes) {
  EXPECT_THAT(confusions(Unit::Word, "blank", "", ""), ElementsAre(LabelPair{"'blank'", "blank"}));
  EXPECT_THAT(confusions(Unit::Word, "na", "", "other"), ElementsAre(LabelPair{"na", "'other'"}));
}

TEST_F(ConfusionsOf, AStimulusWithoutPhonesAreNoneButOfWords) {
  for (const Unit unit : kUnits) {
    if (unit == Unit::Word) continue;
    EXPECT_THAT(confusions(unit, "bada", "", "bat"), IsEmpty());
    EXPECT_THAT(stimuli_of(trial("bada", "", "bat"), unit), IsEmpty());
  }
}

TEST_F(ConfusionsOf, EveryStimulusWeighOneWhereTiesAreAveraged) {
  ScoringRules rules;
  rules.ties = TieRule::Averaged;
  for (const auto& word : dictionary().spellings()) {
    for (const auto& said : dictionary().pronunciations(word)) {
      for (const auto& response : dictionary().spellings()) {
        const auto made = trial(word, spell(said), response);
        const auto scored = score(made, dictionary(), rules);
        for (const Unit unit : kUnits) {
          std::map<std::string, double> expected;
          for (const auto& stimulus : stimuli_of(made, unit)) expected[stimulus] += 1.0;
          std::map<std::string, double> found;
          for (const auto& pair : confusions_of(made, scored, unit)) {
            found[pair.stimulus] += pair.weight;
          }
          ASSERT_EQ(found.size(), expected.size()) << word << " as " << response;
          for (const auto& [stimulus, weight] : expected) {
            ASSERT_NEAR(found[stimulus], weight, 1e-12) << word << " as " << response;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace bimodal::analysis
