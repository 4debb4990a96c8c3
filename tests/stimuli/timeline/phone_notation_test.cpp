#include "stimuli/timeline/phone_notation.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::array kNotations{Notation::Arpabet, Notation::Ipa, Notation::XSampa};

std::string ipa(std::string_view text) {
  return spell(read_phones(text, Notation::Ipa));
}

std::string x_sampa(std::string_view text) {
  return spell(read_phones(text, Notation::XSampa));
}

std::string message_about(std::string_view text, Notation notation) {
  try {
    (void)read_phones(text, notation);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(PhoneNotation, ReadsBackEveryPhone) {
  for (const auto notation : kNotations) {
    std::set<std::string_view> different;
    for (const Phone phone : all_phones()) {
      EXPECT_THAT(read_phones(written(phone, notation), notation), ElementsAre(phone))
          << symbol(phone);
      different.insert(written(phone, notation));
    }
    EXPECT_EQ(different.size(), kPhoneCount);
  }
}

TEST(PhoneNotation, ReadsBackEverySequence) {
  Random random{42};
  for (const auto notation : kNotations) {
    for (const Phone one : all_phones()) {
      for (const Phone other : all_phones()) {
        const std::vector<Phone> both{one, other};
        ASSERT_EQ(read_phones(write_phones(both, notation), notation), both) << spell(both);
      }
    }
    for (int i = 0; i < 1'000; ++i) {
      std::vector<Phone> phones(1 + random.below(12));
      for (auto& phone : phones) phone = all_phones()[random.below(kPhoneCount)];
      const auto text = write_phones(phones, notation);
      ASSERT_EQ(read_phones(text, notation), phones) << text;
    }
  }
}

TEST(PhoneNotation, WritesIpaInUtf8AndXSampaInAscii) {
  for (const Phone phone : all_phones()) {
    EXPECT_TRUE(is_utf8(written(phone, Notation::Ipa)));
    for (const char letter : written(phone, Notation::XSampa)) EXPECT_GT(letter, ' ');
  }
  const std::vector phones{Phone::CH, Phone::ER, Phone::T, Phone::SH};
  EXPECT_EQ(write_phones(phones, Notation::Arpabet), "CH ER T SH");
  EXPECT_EQ(write_phones(phones, Notation::Ipa), "t\u0361\u0283\u025Dt.\u0283");
  EXPECT_EQ(write_phones(phones, Notation::XSampa), "tS3`t.S");
}

TEST(PhoneNotation, LongestSymbolWins) {
  EXPECT_EQ(ipa("tʃaɪnaʊt"), "CH AY N AW T");
  EXPECT_EQ(ipa("t.ʃ"), "T SH");
  EXPECT_EQ(x_sampa("tSaInaUt"), "CH AY N AW T");
  EXPECT_EQ(x_sampa("r\\3`"), "R ER");
}

TEST(PhoneNotation, PassesOverStressLengthTiesAndBrackets) {
  EXPECT_EQ(ipa("/ˈstuː/"), "S T UW");
  EXPECT_EQ(ipa("[ˌa͡ɪ.ˈaɪ̯]"), "AY AY");
  EXPECT_EQ(ipa("s t\tuː\n"), "S T UW");
  EXPECT_EQ(x_sampa("\"stu:"), "S T UW");
  EXPECT_EQ(x_sampa("%f@.\"nEt-Ik"), "F AX N EH T IH K");
}

TEST(PhoneNotation, UnderstandsOtherSymbolsOfTheSameSounds) {
  EXPECT_EQ(ipa("ɚ ɝ ɜː ɜɹ"), "ER ER ER ER");
  EXPECT_EQ(ipa("r ɹ ɻ g ɡ ɫ ɾ ɒ"), "R R R G G L D AA");
  EXPECT_EQ(ipa("ʧ ʤ t͜ʃ əʊ"), "CH JH CH OW");
  EXPECT_EQ(x_sampa("@` 3` 3: r t_S Q @U 4"), "ER ER ER R CH AA OW D");
  EXPECT_EQ(ipa("stu | but"), "S T UW rest B UW T");
}

TEST(PhoneNotation, ReadsArpabetInAnyCaseWithStress) {
  EXPECT_THAT(read_phones(" s T uw1\n", Notation::Arpabet),
              ElementsAre(Phone::S, Phone::T, Phone::UW));
}

TEST(PhoneNotation, NamesTheSymbolThatIsNotKnownItsPlaceAndWhatIsNear) {
  EXPECT_THAT(message_about("ˈt͡ʃaɪx", Notation::Ipa),
              AllOf(HasSubstr("\"x\", character 7"), HasSubstr("the symbols are | p b")));
  EXPECT_THAT(message_about("bet", Notation::Ipa),
              AllOf(HasSubstr("\"e\", character 2"), HasSubstr("near it is eɪ (EY)")));
  EXPECT_THAT(message_about("Si", Notation::Ipa), HasSubstr("near it is ʃ (SH)"));
  EXPECT_THAT(message_about("ʃi", Notation::XSampa),
              AllOf(HasSubstr("\"ʃ\", character 1"), HasSubstr("near it is S (SH)")));
  EXPECT_THAT(message_about("t_hu", Notation::XSampa), HasSubstr("\"_\", character 2"));
  EXPECT_THAT(message_about("S TT UW", Notation::Arpabet),
              AllOf(HasSubstr("\"TT\", symbol 2"), HasSubstr("did you mean TH?")));
  EXPECT_THAT(message_about("\xFF", Notation::Ipa), HasSubstr("UTF-8"));
}

TEST(PhoneNotation, ReadsNoPhonesOutOfNothing) {
  EXPECT_THAT(message_about("", Notation::Ipa), HasSubstr("write e.g. \"stu\""));
  EXPECT_THAT(message_about("/ˈ/", Notation::Ipa), HasSubstr("no phones"));
  EXPECT_THAT(message_about("  ", Notation::Arpabet), HasSubstr("write e.g. \"S T UW\""));
}

}  // namespace
}  // namespace bimodal
