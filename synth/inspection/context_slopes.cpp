#include "synth/inspection/context_slopes.hpp"

#include <algorithm>
#include <array>
#include <chrono>

#include "synth/face/jaw.hpp"
#include "synth/face/tongue.hpp"
#include "synth/speech/articulation.hpp"

namespace bimodal::synth {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kArticulators = 5;

constexpr std::array<std::string_view, kArticulators> kNames{
    "lip protrusion", "lip opening", "jaw", "tongue tip forward", "tongue tip up"};

using Places = std::array<double, kArticulators>;

/// The table of the talker, row by row.
struct Row {
  Phone phone;  ///< which stands for all
  std::string_view consonants;
  std::array<std::optional<double>, kArticulators> measured;
  std::array<std::string_view, kArticulators> words;
};

constexpr auto kNone = std::nullopt;

constexpr std::string_view kNoReversal =
    "the talker's goes against the vowels a little; a weighted mean of targets can at most stay";
constexpr std::string_view kFitOfT =
    "its opening has the alpha .55 of talkers' lips (18 tokens); JD3's jaw is firmer than their "
    "lips";
constexpr std::string_view kTipAtContact =
    "the tip has its place at the teeth or ridge in every context, as contact needs";
constexpr std::string_view kRoundingOfTh =
    "as all consonants without a lip shape of their own it gives way to rounding (\"stew\")";
constexpr std::string_view kOpeningOfTh =
    "its opening has the alpha .83 of talkers' lips; JD3 holds his still";
constexpr std::string_view kRoundingOfS =
    "Cohen & Massaro (1993) give /s t/ alpha .06 in \"stew\"; JD3's /s/ keeps its lips";
constexpr std::string_view kOpeningOfS =
    "its opening has the alpha .61 of talkers' lips; JD3 holds his still";
constexpr std::string_view kTipOfS = "the jaw carries the tip; JD3's keeps its height";
constexpr std::string_view kOpeningOfL =
    "its opening has the alpha 1.6 of talkers' lips (6 tokens); JD3's follows the vowel";
constexpr std::string_view kOpeningOfSh =
    "its opening has the alpha 1.26 of one token of /dZ/; JD3's follows the vowel, while his jaw "
    "stays: here jaw and opening move together";
constexpr std::string_view kJawOfSh =
    "JD3's jaw stays while his lips follow; here jaw and opening move together";
constexpr std::string_view kHeldLip =
    "a lip held at the teeth is not pushed out here; JD3's lips follow the vowel a little";
constexpr std::string_view kTipOfF =
    "its opening is firm (alpha 2.2), so that the lip meets the teeth, and the jaw carries the tip";
constexpr std::string_view kOpeningOfK =
    "the jaw does as JD3's; his lips also open and close by themselves with the vowel";

// clang-format off
const std::array<Row, 8>& rows() {
  static const std::array<Row, 8> table{{
      {Phone::P,  "P B M",  {.57, -.04, -.17, .81, .16}, {"", "", kNoReversal, "", ""}},
      {Phone::F,  "F V",    {.39, -.04, -.21, .85, .37},
       {kHeldLip, "", kNoReversal, "", kTipOfF}},
      {Phone::TH, "TH DH",  {.47, -.03, .40, 0, -.22},
       {kRoundingOfTh, kOpeningOfTh, "", "", kNoReversal}},
      {Phone::T,  "T D N",  {.78, .52, .08, .28, -.39},
       {"", "", kFitOfT, kTipAtContact, kNoReversal}},
      {Phone::S,  "S Z",    {.33, .08, .40, -.04, -.05},
       {kRoundingOfS, kOpeningOfS, "", "", kTipOfS}},
      {Phone::L,  "L",      {.81, .56, .34, -.23, -.24},
       {"", kOpeningOfL, "", kNoReversal, kNoReversal}},
      {Phone::SH, "SH ZH",  {.32, .95, 0, .14, .16}, {"", kOpeningOfSh, kJawOfSh, "", ""}},
      {Phone::K,  "K G NG", {.83, .85, .46, kNone, kNone}, {"", kOpeningOfK, "", "", ""}},
  }};
  return table;
}

// clang-format on

class ContextRuler {
 public:
  ContextRuler(const SegmentTable& table, const Head& head) : table_{table}, head_{head} {}

  /// Slopes of the consonant's places on the vowel's.
  Places slopes(Phone consonant) {
    std::array<Places, 3> of_vowel{};
    std::array<Places, 3> of_consonant{};
    constexpr std::array kVowels{Phone::AA, Phone::IY, Phone::UW};
    for (std::size_t i = 0; i < kVowels.size(); ++i) {
      const std::array<TimedSegment, 5> said{{{Phone::Rest, 0ms, 200ms},
                                              {kVowels.at(i), 200ms, 150ms},
                                              {consonant, 350ms, 100ms},
                                              {kVowels.at(i), 450ms, 150ms},
                                              {Phone::Rest, 600ms, 200ms}}};
      const Articulation articulation{said, table_};
      of_vowel.at(i) = places(articulation.at(said[1].centre()));
      of_consonant.at(i) = places(articulation.at(said[2].centre()));
    }
    Places slopes{};
    for (std::size_t a = 0; a < kArticulators; ++a) slopes.at(a) = slope(of_vowel, of_consonant, a);
    return slopes;
  }

 private:
  Places places(const Pose& pose) {
    head_.pose(pose, posed_);
    const JawMotion jaw{.opening_deg = value(pose, Control::Jaw),
                        .thrust_mm = value(pose, Control::JawThrust)};
    const auto tip = tongue_cage(pose, jaw).back();
    const auto& lips = posed_.lips;
    return {(lips.upper_protrusion_mm + lips.lower_protrusion_mm) / 2,
            lips.inner_height_mm,
            value(pose, Control::Jaw),
            tip.z,
            tip.y};
  }

  static double slope(const std::array<Places, 3>& x,
                      const std::array<Places, 3>& y,
                      std::size_t a) {
    double mean_x = 0;
    double mean_y = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      mean_x += x.at(i).at(a) / 3;
      mean_y += y.at(i).at(a) / 3;
    }
    double covariance = 0;
    double variance = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      covariance += (x.at(i).at(a) - mean_x) * (y.at(i).at(a) - mean_y);
      variance += (x.at(i).at(a) - mean_x) * (x.at(i).at(a) - mean_x);
    }
    return variance > 0 ? covariance / variance : 0;
  }

  const SegmentTable& table_;
  const Head& head_;
  PosedHead posed_;
};

}  // namespace

std::vector<ContextSlope> context_slopes(const SegmentTable& table, const Head& head) {
  ContextRuler ruler{table, head};
  std::vector<ContextSlope> slopes;
  for (const auto& row : rows()) {
    const auto places = ruler.slopes(row.phone);
    for (std::size_t a = 0; a < kArticulators; ++a) {
      if (!row.measured.at(a)) continue;
      slopes.push_back({.consonants = row.consonants,
                        .articulator = kNames.at(a),
                        .slope = places.at(a),
                        .measured = *row.measured.at(a),
                        .word = row.words.at(a)});
    }
  }
  return slopes;
}

}  // namespace bimodal::synth
