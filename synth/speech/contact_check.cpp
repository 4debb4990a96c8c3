#include "synth/speech/contact_check.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "synth/speech/articulation.hpp"
#include "synth/speech/durations.hpp"

namespace bimodal::synth {

namespace {

constexpr Milliseconds kStep{1};
/// How far beyond its own segment a contact is looked for.
constexpr Milliseconds kAround{100};

bool makes_contact(Phone phone) {
  using enum Phone;
  return phone == P || phone == B || phone == M || phone == F || phone == V;
}

Control contact_of(Phone phone) {
  return phone == Phone::F || phone == Phone::V ? Control::LowerLipTuck : Control::LipClosure;
}

Milliseconds longest_contact(const Articulation& articulation,
                             const TimedSegment& timed,
                             Control control) {
  Milliseconds longest{};
  Milliseconds run{};
  for (auto time = timed.start - kAround; time < timed.end() + kAround; time += kStep) {
    run = value(articulation.at(time), control) >= 1 ? run + kStep : Milliseconds{};
    longest = std::max(longest, run);
  }
  return longest;
}

class ContactCheck {
 public:
  explicit ContactCheck(const SegmentTable& table) : table_{table} {
    report_.briefest = Milliseconds{std::numeric_limits<double>::infinity()};
  }

  void check(Phone first, Phone vowel, Phone last, double rate) {
    const auto segments = at_rate(timed(std::array<Segment, 3>{first, vowel, last}), rate);
    const Articulation articulation{segments, table_};
    for (const std::size_t place : {1U, 3U}) {
      const Phone phone = segments[place].segment.from;
      if (!makes_contact(phone)) continue;
      const auto longest = longest_contact(articulation, segments[place], contact_of(phone));
      ++report_.contexts;
      report_.briefest = std::min(report_.briefest, longest);
      if (longest >= kShownPicture) continue;
      const std::array context{first, vowel, last};
      report_.missed.push_back(
          {.context = spell(context), .phone = phone, .rate = rate, .longest = longest});
    }
  }

  ContactReport report() && { return std::move(report_); }

 private:
  const SegmentTable& table_;
  ContactReport report_;
};

}  // namespace

ContactReport check_contacts(const SegmentTable& table,
                             std::span<const double> rates,
                             const std::function<void(double)>& progress) {
  std::vector<Phone> consonants;
  std::vector<Phone> vowels;
  for (const Phone phone : all_phones()) {
    if (is_consonant(phone)) consonants.push_back(phone);
    if (is_vowel(phone)) vowels.push_back(phone);
  }
  ContactCheck check{table};
  double done = 0;
  for (const double rate : rates) {
    for (const Phone vowel : vowels) {
      for (const Phone first : consonants) {
        for (const Phone last : consonants) {
          if (makes_contact(first) || makes_contact(last)) check.check(first, vowel, last, rate);
        }
      }
      ++done;
      if (progress) progress(done / static_cast<double>(rates.size() * vowels.size()));
    }
  }
  return std::move(check).report();
}

}  // namespace bimodal::synth
