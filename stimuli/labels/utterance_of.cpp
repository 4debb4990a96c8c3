#include <algorithm>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "stimuli/labels/label_time.hpp"
#include "stimuli/labels/labels.hpp"
#include "stimuli/labels/phone_name.hpp"

namespace bimodal {

namespace {

using Kind = PhoneName::Kind;

/// A stretch of the recording; it begins where the one before it ends.
struct Stretch {
  PhoneName name;
  Duration end{};

  [[nodiscard]] bool is_rest() const {
    return name.kind == Kind::Phones && name.phones.front() == Phone::Rest;
  }
};

[[noreturn]] void refuse_label(const Tier& tier,
                               const Label& label,
                               std::string_view finding,
                               std::string_view remedy) {
  throw Error{fmt::format("tier \"{}\": the label {} at {} s {}; {}",
                          tier.name,
                          in_quotes(label.text),
                          seconds_text(label.start),
                          finding,
                          remedy)};
}

std::string phones_to_write() {
  return fmt::format(
      "write one of {}, a name of Festival's or TIMIT's phone sets, or \"sil\" for silence",
      spell(all_phones().subspan(1)));
}

/// Labels and gaps, from 0 to the end.
std::vector<Stretch> stretches_of(const Tier& tier, Duration end) {
  const PhoneName rest{Kind::Phones, {Phone::Rest}};
  std::vector<Stretch> stretches;
  Duration reached{};
  for (const auto& label : tier.labels) {
    auto name = phone_name(label.text);
    if (name.kind == Kind::Unknown) refuse_label(tier, label, "is no phone", phones_to_write());
    if (label.start < reached - kRounding || label.end > end + kRounding) {
      refuse_label(tier,
                   label,
                   "is not between the one before it and the end of the recording",
                   "mend its times");
    }
    if (label.start > reached + kRounding) stretches.push_back({rest, label.start});
    Stretch stretch{std::move(name), std::min(label.end, end)};
    const bool shortest = label.end - label.start < kRounding;
    if (shortest && stretch.is_rest()) continue;
    if (shortest) refuse_label(tier, label, "is a point", "give it a start and an end");
    reached = stretch.end;
    stretches.push_back(std::move(stretch));
  }
  if (end > reached + kRounding) {
    stretches.push_back({rest, end});
  } else if (!stretches.empty()) {
    stretches.back().end = end;
  }
  return stretches;
}

void append(Utterance& utterance, Phone phone, Duration end) {
  const Duration start = utterance.end();
  if (end <= start) return;
  auto& phones = utterance.phones;
  if (phone == Phone::Rest && !phones.empty() && phones.back().phone == Phone::Rest) {
    phones.back().duration = end - phones.back().start;
  } else {
    phones.push_back({.phone = phone, .start = start, .duration = end - start});
  }
}

void append(Utterance& utterance, const Stretch& stretch) {
  const auto& phones = stretch.name.phones;
  const Duration start = utterance.end();
  if (phones.size() == 2) append(utterance, phones.front(), start + (stretch.end - start) / 2);
  append(utterance, phones.back(), stretch.end);
}

/// A glottal stop before a phone is part of it, after the last phone part of that, else rest.
void append_glottal(Utterance& utterance, Duration end) {
  auto& phones = utterance.phones;
  if (phones.empty() || phones.back().phone == Phone::Rest) {
    append(utterance, Phone::Rest, end);
  } else {
    phones.back().duration = end - phones.back().start;
  }
}

}  // namespace

Utterance utterance_of(const Tier& tier, Duration end) {
  const auto stretches = stretches_of(tier, end);
  Utterance utterance;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const auto& stretch = stretches[i];
    const auto* const next = i + 1 < stretches.size() ? &stretches[i + 1] : nullptr;
    const bool released = stretch.name.kind == Kind::Closure && next != nullptr &&
                          next->name.kind == Kind::Phones &&
                          is_release(stretch.name.phones.front(), next->name.phones.front());
    const bool glottal = stretch.name.kind == Kind::Glottal;
    const bool leads = glottal && next != nullptr && !next->is_rest();
    // What comes next begins where the utterance ends, so it takes the time of what is left out.
    if (released || leads) continue;
    if (glottal) {
      append_glottal(utterance, stretch.end);
    } else {
      append(utterance, stretch);
    }
  }
  return utterance;
}

}  // namespace bimodal
