#include "synth/inspection/contact_table.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include "synth/speech/articulation.hpp"
#include "synth/speech/durations.hpp"

namespace bimodal::synth {

namespace {

constexpr Milliseconds kPicture{1000.0 / 60};
constexpr Milliseconds kAround{50};       // pictures this far outside the sound count too
constexpr std::size_t kMostPictures = 6;  // of those where the control is farthest

/// What a group of sounds must show. A measure meets the requirement if least <= measure <= most.
struct Requirement {
  std::string_view sounds;
  std::string_view words;
  Control control;  ///< farthest in the pictures to be looked at
  double sign;      ///< of "farthest"
  double least;
  double most;
  double (*measure)(MouthRuler& ruler);
};

// Lips shut, lip to teeth, teeth and tongue seen, and the opening of round lips: limits of this
// project's requirements for a face to be lipread. The 0.5 mm at the ridge, the blade's widths
// (those of T D N and of L lie 1.5 mm apart) and the 38 mm of round lips were chosen by us.
constexpr double kAny = std::numeric_limits<double>::infinity();

constexpr std::array kRequirements{
    Requirement{"P B M",
                "lips shut: widest gap along the slit at most 0.05 mm",
                Control::LipClosure,
                1,
                0,
                0.05,
                [](MouthRuler& ruler) { return ruler.lips().largest_gap_mm; }},
    Requirement{"F V",
                "lower lip to upper incisors -0.2 to 0.3 mm",
                Control::LowerLipTuck,
                1,
                -kMostPenetration,
                0.3,
                [](MouthRuler& ruler) { return ruler.lip_to_incisors_mm(); }},
    Requirement{"F V",
                "upper teeth seen: at least 5 mm2",
                Control::LowerLipTuck,
                1,
                5,
                kAny,
                [](MouthRuler& ruler) { return ruler.seen().upper_teeth_mm2; }},
    Requirement{"TH DH",
                "tongue seen between the teeth: at least 4 mm2",
                Control::TongueLength,
                1,
                4,
                kAny,
                [](MouthRuler& ruler) { return ruler.seen().tongue_between_teeth_mm2; }},
    Requirement{"T D N L",
                "tongue at the alveolar ridge: at most 0.5 mm from it",
                Control::TongueTip,
                1,
                -kMostPenetration,
                0.5,
                [](MouthRuler& ruler) { return ruler.tongue().to_ridge_mm; }},
    Requirement{"T D N",
                "blade wide: at most 3.5 mm between its sides and the upper gum",
                Control::TongueTip,
                1,
                -kMostPenetration,
                3.5,
                [](MouthRuler& ruler) { return ruler.tongue().beside_mm; }},
    Requirement{"L",
                "blade narrow: at least 4.2 mm between its sides and the upper gum",
                Control::TongueTip,
                1,
                4.2,
                kAny,
                [](MouthRuler& ruler) { return ruler.tongue().beside_mm; }},
    Requirement{"W WH UW",
                "lips round: opening 1 to 3 mm high",
                Control::LipWidth,
                -1,
                1,
                3,
                [](MouthRuler& ruler) { return ruler.lips().inner_height_mm; }},
    Requirement{"W WH UW",
                "lips round: at most 38 mm from corner to corner (rest 51.5)",
                Control::LipWidth,
                -1,
                0,
                38,
                [](MouthRuler& ruler) { return ruler.lips().outer_width_mm; }},
};

bool concerns(const Requirement& requirement, Phone phone) {
  const auto name = symbol(phone);
  std::string_view rest = requirement.sounds;
  while (!rest.empty()) {
    const auto end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == name) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

double distance_to(const Requirement& requirement, double measure) {
  return std::max({0.0, requirement.least - measure, measure - requirement.most});
}

/// How far inside its limits a measure lies; negative: outside. Limits that no sound can miss in
/// one direction do not count.
double margin(const Requirement& requirement, double measure) {
  const double above = requirement.least == 0 ? kAny : measure - requirement.least;
  return std::min(above, requirement.most - measure);
}

struct Syllable {
  std::array<Segment, 3> sounds;
  double rate = 1;
};

class Looking {
 public:
  Looking(const Head& head, const SegmentTable& table) : table_{table}, ruler_{head} {
    for (const auto& requirement : kRequirements) {
      rows_.push_back({.sounds = std::string{requirement.sounds},
                       .requirement = std::string{requirement.words}});
    }
    margins_.assign(rows_.size(), kAny);
  }

  void look_at(const Syllable& syllable) {
    const auto segments = at_rate(timed(syllable.sounds), syllable.rate);
    const Articulation articulation{segments, table_};
    for (std::size_t place = 1; place <= syllable.sounds.size(); ++place) {
      for (std::size_t r = 0; r < kRequirements.size(); ++r) {
        if (!concerns(kRequirements.at(r), segments[place].segment.from)) continue;
        for (const double phase : {0.0, 0.5}) {
          look_at(r, articulation, segments[place], phase, syllable);
        }
      }
      look_for_penetrations(articulation.at(segments[place].centre()), syllable);
      look_for_penetrations(articulation.at(segments[place].end()), syllable);
    }
  }

  void add_to(ContactTable& table, std::vector<double>& margins) const {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      auto& sum = table.rows[r];
      sum.cases += rows_[r].cases;
      sum.met += rows_[r].met;
      if (margins_[r] >= margins[r]) continue;
      margins[r] = margins_[r];
      sum.worst = rows_[r].worst;
      sum.worst_case = rows_[r].worst_case;
    }
    if (deepest_.worst() > table.deepest.worst()) table.deepest_case = deepest_case_;
    for (const auto member : {&Penetrations::lip_in_lip,
                              &Penetrations::flesh_in_teeth,
                              &Penetrations::tongue_in_teeth,
                              &Penetrations::tongue_in_palate,
                              &Penetrations::tongue_in_flesh}) {
      table.deepest.*member = std::max(table.deepest.*member, deepest_.*member);
    }
    table.pictures += pictures_;
  }

 private:
  void look_at(std::size_t r,
               const Articulation& articulation,
               const TimedSegment& timed,
               double phase,
               const Syllable& syllable) {
    const auto& requirement = kRequirements.at(r);
    std::vector<Pose> poses;
    const double first = std::ceil((timed.start - kAround) / kPicture - phase);
    for (double picture = first; (picture + phase) * kPicture < timed.end() + kAround; ++picture) {
      poses.push_back(articulation.at((picture + phase) * kPicture));
    }
    std::ranges::stable_sort(poses, std::ranges::greater{}, [&](const Pose& pose) {
      return requirement.sign * value(pose, requirement.control);
    });
    double best = 0;
    double best_margin = -kAny;
    for (std::size_t i = 0; i < std::min(kMostPictures, poses.size()); ++i) {
      ruler_.take(poses[i]);
      const double measure = requirement.measure(ruler_);
      if (margin(requirement, measure) > best_margin) {
        best = measure;
        best_margin = margin(requirement, measure);
      }
      if (distance_to(requirement, measure) == 0) break;
    }
    auto& row = rows_[r];
    ++row.cases;
    if (distance_to(requirement, best) == 0) ++row.met;
    if (best_margin >= margins_[r]) return;
    margins_[r] = best_margin;
    row.worst = best;
    row.worst_case = fmt::format("{} in {}, rate {:g}, pictures from {:.1f} ms",
                                 symbol(timed.segment.from),
                                 spell(syllable.sounds),
                                 syllable.rate,
                                 phase * kPicture.count());
  }

  void look_for_penetrations(const Pose& pose, const Syllable& syllable) {
    ruler_.take(pose);
    const auto found = ruler_.penetrations();
    ++pictures_;
    if (found.worst() > deepest_.worst()) {
      deepest_case_ = fmt::format("{}, rate {:g}", spell(syllable.sounds), syllable.rate);
    }
    for (const auto member : {&Penetrations::lip_in_lip,
                              &Penetrations::flesh_in_teeth,
                              &Penetrations::tongue_in_teeth,
                              &Penetrations::tongue_in_palate,
                              &Penetrations::tongue_in_flesh}) {
      deepest_.*member = std::max(deepest_.*member, found.*member);
    }
  }

  const SegmentTable& table_;
  MouthRuler ruler_;
  std::vector<ContactRow> rows_;
  std::vector<double> margins_;
  Penetrations deepest_;
  std::string deepest_case_;
  std::size_t pictures_ = 0;
};

bool is_wanted(const ContactScope& scope, const std::array<Phone, 3>& sounds) {
  return scope.with.empty() || std::ranges::find_first_of(sounds, scope.with) != sounds.end();
}

std::vector<Syllable> syllables(const ContactScope& scope) {
  std::vector<Phone> consonants;
  std::vector<Phone> vowels;
  for (const Phone phone : all_phones()) {
    if (is_consonant(phone)) consonants.push_back(phone);
    if (is_vowel(phone)) vowels.push_back(phone);
  }
  std::vector<Syllable> result;
  std::size_t number = 0;
  for (const double rate : scope.rates) {
    for (const Phone vowel : vowels) {
      for (const Phone first : consonants) {
        for (const Phone last : consonants) {
          if (!is_wanted(scope, {first, vowel, last})) continue;
          if (number++ % scope.every == 0) result.push_back({{first, vowel, last}, rate});
        }
      }
    }
  }
  return result;
}

}  // namespace

ContactTable measure_contacts(const Head& head,
                              const SegmentTable& table,
                              const ContactScope& scope) {
  const auto all = syllables(scope);
  ContactTable result;
  for (const auto& requirement : kRequirements) {
    result.rows.push_back(
        {.sounds = std::string{requirement.sounds}, .requirement = std::string{requirement.words}});
  }
  std::vector<double> margins(result.rows.size(), kAny);
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  const auto look = [&] {
    Looking looking{head, table};
    for (std::size_t i = next++; i < all.size(); i = next++) {
      looking.look_at(all[i]);
      if (!scope.progress || i % 64 != 0) continue;
      const std::lock_guard lock{mutex};
      scope.progress(static_cast<double>(i) / static_cast<double>(all.size()));
    }
    const std::lock_guard lock{mutex};
    looking.add_to(result, margins);
  };
  std::vector<std::jthread> threads;
  for (std::size_t t = 1; t < scope.threads; ++t) threads.emplace_back(look);
  look();
  threads.clear();
  return result;
}

}  // namespace bimodal::synth
