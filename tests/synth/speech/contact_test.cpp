// What a face must show to be lip-read, checked over every vowel-consonant-vowel context: contacts
// are reached by virtual targets beyond contact, never by a rule that knows a phone's name.
#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"
#include "synth/speech/articulation.hpp"

namespace bimodal::synth {
namespace {

using namespace std::chrono_literals;
using enum Phone;

constexpr Duration kFrame{16'666'667};

const SegmentTable& english() {
  static const SegmentTable table{asset("synth/assets/segments/english.json")};
  return table;
}

struct Context {
  std::string name;
  Utterance utterance;
  TimedPhone middle;  ///< the segment that is looked at
};

struct Timed {
  Phone phone;
  Duration duration;
};

/// `middle` is the index of the phone that is looked at; a Rest in `sequence` stands for none.
Context context(const std::vector<Timed>& sequence, std::size_t middle) {
  Context made;
  auto& phones = made.utterance.phones;
  phones.push_back({.phone = Rest, .start = {}, .duration = 200ms});
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    if (sequence[i].phone == Rest) continue;
    phones.push_back({.phone = sequence[i].phone,
                      .start = made.utterance.end(),
                      .duration = sequence[i].duration});
    if (i == middle) made.middle = phones.back();
  }
  phones.push_back({.phone = Rest, .start = made.utterance.end(), .duration = 200ms});
  for (const auto& timed : phones) made.name += std::string{symbol(timed.phone)} + ' ';
  return made;
}

std::vector<Phone> vowels_and_rest() {
  std::vector<Phone> phones{Rest};
  for (const Phone phone : all_phones()) {
    if (is_vowel(phone)) phones.push_back(phone);
  }
  return phones;
}

/// Every vowel or pause, `consonant`, every vowel or pause.
std::vector<Context> contexts_of(Phone consonant, Duration duration = 80ms) {
  std::vector<Context> contexts;
  for (const Phone before : vowels_and_rest()) {
    for (const Phone after : vowels_and_rest()) {
      contexts.push_back(context({{before, 150ms}, {consonant, duration}, {after, 150ms}}, 1));
    }
  }
  return contexts;
}

/// How long `holds` of the pose is true without a break, from 100 ms before to 100 ms after the
/// middle phone, to 2 ms. From one frame's duration on, a 60-Hz display shows it whatever
/// its phase.
template <typename Predicate>
Duration longest(const Context& context, Predicate holds) {
  const Articulation articulation{context.utterance, english()};
  Duration best{};
  Duration run{};
  for (Duration time = context.middle.start - 100ms; time < context.middle.end() + 100ms;
       time += 2ms) {
    run = holds(articulation.at(time)) ? run + 2ms : Duration{};
    best = std::max(best, run);
  }
  return best;
}

auto at_least(Control control, double threshold) {
  return [=](const Pose& pose) { return value(pose, control) >= threshold; };
}

auto at_most(Control control, double threshold) {
  return [=](const Pose& pose) { return value(pose, control) <= threshold; };
}

TEST(Contact, LipsCloseForBilabialsInEveryContext) {
  for (const Phone consonant : {P, B, M}) {
    for (const Duration duration : {Duration{40ms}, Duration{80ms}, Duration{120ms}}) {
      for (const auto& context : contexts_of(consonant, duration)) {
        EXPECT_GE(longest(context, at_least(Control::LipClosure, 1)),
                  duration > 40ms ? 2 * kFrame : kFrame)
            << context.name;
      }
    }
  }
}

TEST(Contact, LipsCloseForBriefBilabialsInClusters) {
  for (const Phone vowel : vowels_and_rest()) {
    if (vowel == Rest) continue;
    for (const auto& cluster : std::vector<std::vector<Phone>>{
             {S, P, R}, {Rest, P, L}, {Rest, B, R}, {S, M, Rest}, {Rest, P, Y}}) {
      const auto made =
          context({{cluster[0], 60ms}, {cluster[1], 40ms}, {cluster[2], 60ms}, {vowel, 120ms}}, 1);
      EXPECT_GE(longest(made, at_least(Control::LipClosure, 1)), kFrame) << made.name;
    }
    for (const auto& cluster : std::vector<std::vector<Phone>>{
             {L, P, Rest}, {L, M, Rest}, {R, B, Z}, {R, M, D}, {M, P, T}, {S, P, S}}) {
      const auto made =
          context({{vowel, 120ms}, {cluster[0], 60ms}, {cluster[1], 40ms}, {cluster[2], 60ms}}, 2);
      EXPECT_GE(longest(made, at_least(Control::LipClosure, 1)), kFrame) << made.name;
    }
  }
}

TEST(Contact, LipsArePartedWellWithinEveryVowelBetweenBilabials) {
  for (const Phone vowel : vowels_and_rest()) {
    if (vowel == Rest) continue;
    const auto made = context({{B, 80ms}, {vowel, 150ms}, {B, 80ms}}, 1);
    EXPECT_GE(longest(made, at_most(Control::LipClosure, 0)), 50ms) << made.name;
  }
}

TEST(Contact, LowerLipMeetsTheTeethForLabiodentalsInEveryContext) {
  for (const Phone consonant : {F, V}) {
    for (const Duration duration : {Duration{40ms}, Duration{80ms}, Duration{120ms}}) {
      for (const auto& context : contexts_of(consonant, duration)) {
        EXPECT_GE(longest(context, at_least(Control::LowerLipTuck, 1)),
                  duration > 40ms ? 2 * kFrame : kFrame)
            << context.name;
      }
    }
  }
}

TEST(Contact, LipsStayApartAndTheLowerLipFreeForOtherConsonants) {
  for (const Phone consonant : {T, S, SH, K, R, TH, W}) {
    for (const auto& context : contexts_of(consonant)) {
      EXPECT_EQ(longest(context, at_least(Control::LipClosure, 0.01)), Duration{}) << context.name;
      EXPECT_EQ(longest(context, at_least(Control::LowerLipTuck, 0.01)), Duration{})
          << context.name;
    }
  }
}

// The head's tip lies 10.2 mm further forward for its viseme "th" than at rest, 2.7 mm past the
// upper incisors, with a length of 15 mm: from 12.5 mm on it shows.
TEST(Contact, TongueTipShowsBetweenTheTeethForDentals) {
  for (const Phone consonant : {TH, DH}) {
    for (const auto& context : contexts_of(consonant)) {
      EXPECT_GE(longest(context, at_least(Control::TongueLength, 12.5)), 2 * kFrame)
          << context.name;
    }
  }
}

TEST(Contact, TongueTipRisesForAlveolars) {
  for (const Phone consonant : {T, D, N, L}) {
    for (const auto& context : contexts_of(consonant)) {
      EXPECT_GE(longest(context, at_least(Control::TongueTip, 9)), 2 * kFrame) << context.name;
    }
  }
}

TEST(Contact, TongueBackRisesForVelars) {
  for (const Phone consonant : {K, G, NG}) {
    for (const auto& context : contexts_of(consonant)) {
      EXPECT_GE(longest(context, at_least(Control::TongueBack, 12)), 2 * kFrame) << context.name;
    }
  }
}

TEST(Contact, LipsNarrowForW) {
  for (const Phone consonant : {W, WH}) {
    for (const auto& context : contexts_of(consonant)) {
      EXPECT_GE(longest(context, at_most(Control::LipWidth, -14)), kFrame) << context.name;
    }
  }
}

TEST(Contact, LipsNarrowForUwBetweenAnyConsonants) {
  std::vector<Phone> consonants{Rest};
  for (const Phone phone : all_phones()) {
    if (is_consonant(phone)) consonants.push_back(phone);
  }
  for (const Phone before : consonants) {
    for (const Phone after : consonants) {
      const auto made = context({{before, 80ms}, {UW, 150ms}, {after, 80ms}}, 1);
      EXPECT_GE(longest(made, at_most(Control::LipWidth, -14)), kFrame) << made.name;
    }
  }
}

// Natural talkers have a tenth of the rounding of /w u/ 113 ms before its sound, half 45 ms before.
TEST(Contact, RoundingOfUwBeginsWithinTheConsonantsThatPrecedeIt) {
  const auto stew = context({{S, 140ms}, {T, 60ms}, {UW, 200ms}}, 2);
  const Articulation articulation{stew.utterance, english()};
  const auto protrusion = [&](Duration from_onset) {
    return value(articulation.at(stew.middle.start + from_onset), Control::LipProtrusion);
  };
  EXPECT_NEAR(protrusion(-119ms) / protrusion(100ms), 0.10, 0.01);
  EXPECT_NEAR(protrusion(-22ms) / protrusion(100ms), 0.50, 0.01);
}

}  // namespace
}  // namespace bimodal::synth
