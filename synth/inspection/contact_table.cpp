#include "synth/inspection/contact_table.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include "synth/inspection/contact_requirements.hpp"
#include "synth/speech/articulation.hpp"
#include "synth/speech/durations.hpp"

namespace bimodal::synth {

namespace {

constexpr Milliseconds kPicture{1000.0 / 60};
constexpr Milliseconds kAround{50};       // pictures this far outside the sound count too
constexpr std::size_t kMostPictures = 6;  // of those where the control is farthest
constexpr double kAny = std::numeric_limits<double>::infinity();

struct Syllable {
  std::array<Segment, 3> sounds;
  double rate = 1;
};

class Looking {
 public:
  Looking(const Head& head, const SegmentTable& table) : table_{table}, ruler_{head} {
    for (const auto& requirement : contact_requirements()) {
      rows_.push_back({.sounds = std::string{requirement.sounds},
                       .requirement = std::string{requirement.words}});
    }
    margins_.assign(rows_.size(), kAny);
  }

  void look_at(const Syllable& syllable) {
    const auto segments = at_rate(timed(syllable.sounds), syllable.rate);
    const Articulation articulation{segments, table_};
    for (std::size_t place = 1; place <= syllable.sounds.size(); ++place) {
      for (std::size_t r = 0; r < contact_requirements().size(); ++r) {
        if (!concerns(contact_requirements()[r], segments[place].segment.from)) continue;
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
    const auto& requirement = contact_requirements()[r];
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
  for (const auto& requirement : contact_requirements()) {
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
