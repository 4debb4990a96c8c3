#include "synth/fitting/part.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "synth/speech/claims.hpp"

namespace bimodal::synth {

namespace {

constexpr std::array kParts = std::to_array<Part>({
    {"P", "P B M", Phone::P},
    {"B", "P B M", Phone::B},
    {"M", "P B M", Phone::M},
    {"W", "W", Phone::W},
    {"WH", "W", Phone::WH},
    {"F", "F V", Phone::F},
    {"V", "F V", Phone::V},
    {"TH", "TH DH", Phone::TH},
    {"DH", "TH DH", Phone::DH},
    {"T", "T D N", Phone::T},
    {"D", "T D N", Phone::D},
    {"N", "T D N", Phone::N},
    {"S", "S Z", Phone::S},
    {"Z", "S Z", Phone::Z},
    {"L", "L", Phone::L},
    {"R", "R ER", Phone::R},
    {"ER", "R ER", Phone::ER},
    {"SH", "SH JH", Phone::SH},
    {"ZH", "SH JH", Phone::ZH},
    {"CH", "SH JH", Phone::CH},
    {"JH", "SH JH", Phone::JH},
    {"K", "K G", Phone::K},
    {"G", "K G", Phone::G},
    {"NG", "K G", Phone::NG},
    {"HH", "HH", Phone::HH},
    {"IY", "IY Y", Phone::IY},
    {"Y", "IY Y", Phone::Y},
    {"IH", "IH", Phone::IH},
    {"AY end", "IH", Phone::IH},
    {"EY end", "IH", Phone::EY},
    {"OY end", "IH", Phone::IH},
    {"EH", "EH AE", Phone::EH},
    {"AE", "EH AE", Phone::AE},
    {"EY start", "EH AE", Phone::EY},
    {"AA", "AA", Phone::AA},
    {"AY start", "AA", Phone::AA},
    {"AW start", "AA", Phone::AA},
    {"AH", "AH AX", Phone::AH},
    {"AX", "AH AX", Phone::AX},
    {"AO", "AO OW", Phone::AO},
    {"OY start", "AO OW", Phone::AO},
    {"OW", "AO OW", Phone::OW},
    {"UW", "UW", Phone::UW},
    {"UH", "UH", Phone::UH},
    {"AW end", "UH", Phone::UH},
    {"rest", "rest", Phone::Rest},
});

constexpr std::size_t kClassCount = [] {
  std::size_t count = 1;
  for (std::size_t i = 1; i < kParts.size(); ++i) {
    if (kParts.at(i).class_name != kParts.at(i - 1).class_name) ++count;
  }
  return count;
}();

constexpr std::array<std::string_view, kClassCount> kClasses = [] {
  std::array<std::string_view, kClassCount> classes{};
  std::size_t count = 0;
  for (const auto& part : kParts) {
    if (count == 0 || classes.at(count - 1) != part.class_name) {
      classes.at(count++) = part.class_name;
    }
  }
  return classes;
}();

constexpr bool each_class_stands_together() {
  for (std::size_t i = 0; i < kClassCount; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (kClasses.at(i) == kClasses.at(k)) return false;
    }
  }
  return true;
}

static_assert(each_class_stands_together());

constexpr std::size_t part_at(std::string_view name) {
  std::size_t i = 0;
  while (kParts.at(i).name != name) ++i;  // at() ends it: no constant expression
  return i;
}

struct Halves {
  Phone phone;
  std::size_t start;
  std::size_t end;
};

constexpr std::array<Halves, 4> kHalves{{
    {Phone::AY, part_at("AY start"), part_at("AY end")},
    {Phone::AW, part_at("AW start"), part_at("AW end")},
    {Phone::OY, part_at("OY start"), part_at("OY end")},
    {Phone::EY, part_at("EY start"), part_at("EY end")},
}};

void append_speech(std::vector<SpokenPart>& spoken, const TimedPhone& timed) {
  const double start = Milliseconds{timed.start}.count();
  const double length = Milliseconds{timed.duration}.count();
  const auto* const halves = std::ranges::find(kHalves, timed.phone, &Halves::phone);
  if (halves == kHalves.end()) {
    const auto part = part_named(symbol(timed.phone));
    assert(part);  // every phone is a part or has halves
    spoken.push_back({.part = *part, .centre_ms = start + length / 2});
    return;
  }
  const double first = kDiphthongSplit * length;
  spoken.push_back({.part = halves->start, .centre_ms = start + first / 2});
  spoken.push_back({.part = halves->end, .centre_ms = start + (first + length) / 2});
}

}  // namespace

std::span<const Part> parts() {
  return kParts;
}

std::span<const std::string_view> part_classes() {
  return kClasses;
}

std::size_t class_of(std::size_t part) {
  const auto* const found = std::ranges::find(kClasses, kParts.at(part).class_name);
  return static_cast<std::size_t>(found - kClasses.begin());
}

std::optional<std::size_t> part_named(std::string_view name) {
  const auto* const found = std::ranges::find(kParts, name, &Part::name);
  if (found == kParts.end()) return std::nullopt;
  return static_cast<std::size_t>(found - kParts.begin());
}

std::vector<SpokenPart> spoken_parts(const Utterance& utterance) {
  constexpr std::size_t kRest = part_at("rest");
  const auto speech = speech_interval(utterance);
  if (speech.start == speech.end) return {};
  std::vector<SpokenPart> spoken;
  spoken.push_back({.part = kRest,
                    .centre_ms = (Milliseconds{speech.start} - kRestDistance).count(),
                    .begins = true});
  Duration pause_start{};
  bool pauses = false;
  for (const auto& timed : utterance.phones) {
    if (timed.start < speech.start || timed.start >= speech.end) continue;
    if (timed.phone == Phone::Rest) {
      if (!pauses) pause_start = timed.start;
      pauses = true;
      continue;
    }
    if (pauses) {
      const Milliseconds middle = (Milliseconds{pause_start} + Milliseconds{timed.start}) / 2;
      spoken.push_back({.part = kRest, .centre_ms = middle.count()});
      pauses = false;
    }
    append_speech(spoken, timed);
  }
  spoken.push_back({.part = kRest,
                    .centre_ms = (Milliseconds{speech.end} + kRestDistance).count(),
                    .ends = true});
  return spoken;
}

}  // namespace bimodal::synth
