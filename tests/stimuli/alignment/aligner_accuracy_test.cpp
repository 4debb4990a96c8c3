// How well the aligner does: on Festival's two voices, whose own labels are the truth, and on
// natural sentences.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include <unistd.h>

#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/random.hpp"
#include "tests/stimuli/alignment/spoken_words.hpp"

namespace bimodal {
namespace {

using namespace testing_alignment;

class AlignerAccuracy : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!has_voice(GetParam())) GTEST_SKIP() << "Festival's voice " << GetParam() << " is missing";
  }
};

TEST_P(AlignerAccuracy, FindsFestivalsBoundariesAndReturnsEveryPhone) {
  const synth::Voice voice{GetParam()};
  Aligner aligner;
  std::vector<double> errors;
  for (const auto& word : words(100)) {
    const auto item = voice.speak(word.spelling, word.phones);
    const auto found = aligner.align(item.sound, word.phones);
    ASSERT_EQ(found.words.size(), 1U);
    EXPECT_EQ(found.words.front().phones, word.phones.size());
    const auto of_word = boundary_errors(found.utterance, item.utterance);
    errors.insert(errors.end(), of_word.begin(), of_word.end());
  }
  EXPECT_LE(median_size(errors), 15.0);
  EXPECT_GE(share_within(errors, 50.0), 0.95);
}

// Programs that join or pad sounds put digital zeros between them, beside which even the weak end
// of a word is loud.
TEST_P(AlignerAccuracy, FindsWordsInDigitalSilence) {
  const synth::Voice voice{GetParam()};
  Aligner aligner;
  std::vector<double> errors;
  for (const auto& word : words(40)) {
    const auto item = voice.speak(word.spelling, word.phones);
    const auto zeros = static_cast<std::size_t>(
        nearest_sample(std::chrono::milliseconds{350}, item.sound.rate).count());
    Clip padded = item.sound;
    padded.samples.insert(padded.samples.begin(), zeros, 0.0F);
    padded.samples.insert(padded.samples.end(), zeros, 0.0F);
    auto labels = item.utterance;
    for (auto& timed : labels.phones) timed.start += std::chrono::milliseconds{350};
    labels.phones.front().start = {};
    const auto of_word = boundary_errors(aligner.align(padded, word.phones).utterance, labels);
    errors.insert(errors.end(), of_word.begin(), of_word.end());
  }
  EXPECT_LE(median_size(errors), 15.0);
  EXPECT_GE(share_within(errors, 50.0), 0.90);
}

TEST_P(AlignerAccuracy, WordThatWasSaidFitsBetterThanAnotherOne) {
  const synth::Voice voice{GetParam()};
  Aligner aligner;
  Random random{11};
  const auto list = words(100);
  int better = 0;
  int doubtful = 0;
  int wrong_doubtful = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto& word = list[i];
    const auto& other = list[(i + 1 + random.below(list.size() - 1)) % list.size()];
    const auto item = voice.speak(word.spelling, word.phones);
    const double right = aligner.align(item.sound, word.phones).fit;
    const double wrong = aligner.align(item.sound, other.phones).fit;
    EXPECT_LE(right, 1e-3);
    better += right > wrong ? 1 : 0;
    doubtful += right < kDoubtfulFit ? 1 : 0;
    wrong_doubtful += wrong < kDoubtfulFit ? 1 : 0;
  }
  EXPECT_GE(better, 95);
  EXPECT_LE(doubtful, 5);
  EXPECT_GE(wrong_doubtful, 70);
}

INSTANTIATE_TEST_SUITE_P(Festival,
                         AlignerAccuracy,
                         ::testing::Values("kal", "slt"),
                         [](const auto& voice) { return std::string{voice.param}; });

struct LabelledSentence {
  std::vector<SpokenWord> words;
  std::vector<double> starts_ms;  ///< of the phones
  double end_ms = 0.0;
};

/// The tiers "words" and "phones" of a long TextGrid, as the data has them.
LabelledSentence read_sentence(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  const std::regex interval{R"(xmin = ([0-9.]+)\s+xmax = ([0-9.]+)\s+text = "([A-Za-z]+)\")"};
  const auto phones_at = static_cast<std::ptrdiff_t>(text.find("name = \"phones\""));
  const auto each = [&](std::ptrdiff_t from, std::ptrdiff_t to, const auto& deed) {
    for (std::sregex_iterator found{text.begin() + from, text.begin() + to, interval};
         found != std::sregex_iterator{};
         ++found) {
      if ((*found)[3] == "SIL" || (*found)[3] == "sil") continue;
      deed(std::stod((*found)[1]), std::stod((*found)[2]), (*found)[3].str());
    }
  };
  LabelledSentence read;
  std::vector<double> ends;
  each(0, phones_at, [&](double, double end, const std::string& word) {
    read.words.push_back({word, {Pronunciation{}}});
    ends.push_back(end);
  });
  each(phones_at, std::ssize(text), [&](double start, double end, const std::string& phone) {
    const auto word =
        static_cast<std::size_t>(std::ranges::lower_bound(ends, end - 1e-6) - ends.begin());
    read.words.at(word).pronunciations.front().push_back(phone_from_symbol(phone).value());
    read.starts_ms.push_back(1000.0 * start);
    read.end_ms = 1000.0 * end;
  });
  return read;
}

TEST(AlignerOnNaturalSpeech, FindsTheBoundariesOfLabelledSentences) {
  const char* const data = std::getenv("BIMODAL_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "BIMODAL_TEST_DATA does not say where the data is";
  const std::filesystem::path root{data};
  if (!std::filesystem::exists(root / "lips") || !std::filesystem::exists(root / "clips")) {
    GTEST_SKIP() << "there are no clips/ and lips/ in " << root;
  }
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "there is no ffmpeg";
  const auto folder = std::filesystem::path{testing::TempDir()} /
                      ("bimodal_aligner_accuracy_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  Aligner aligner;
  std::vector<double> errors;
  std::vector<double> fits;
  for (const auto& entry : std::filesystem::directory_iterator{root / "lips"}) {
    if (entry.path().extension() != ".TextGrid") continue;
    const auto clip = root / "clips" / entry.path().stem().concat(".mpg");
    const auto wav = folder / entry.path().stem().concat(".wav");
    const auto command = "ffmpeg -loglevel error -y -i '" + clip.string() +
                         "' -vn -ac 1 -c:a pcm_f32le '" + wav.string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    const auto labelled = read_sentence(entry.path());
    const auto found = aligner.align(read_sound(wav), labelled.words);
    std::size_t at = 0;
    for (const auto& timed : found.utterance.phones) {
      if (timed.phone == Phone::Rest) continue;
      errors.push_back(milliseconds(timed.start) - labelled.starts_ms.at(at++));
    }
    EXPECT_EQ(at, labelled.starts_ms.size());
    errors.push_back(milliseconds(speech_interval(found.utterance).end) - labelled.end_ms);
    fits.push_back(found.fit);
  }
  std::filesystem::remove_all(folder);
  ASSERT_GE(errors.size(), 90U);
  EXPECT_LE(median_size(errors), 15.0);
  EXPECT_GE(share_within(errors, 50.0), 0.95);
  EXPECT_GT(std::ranges::min(fits), kDoubtfulFit);
}

}  // namespace
}  // namespace bimodal
