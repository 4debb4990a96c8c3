#include "synth/speech/claimant.hpp"

namespace bimodal::synth {

int deformability(Phone phone) {
  using enum Phone;
  switch (phone) {
    case F:
    case V:
      return 1;
    case OW:
    case UH:
    case UW:
    case AW:
      return 2;
    case W:
    case WH:
    case R:
      return 3;
    case P:
    case B:
    case M:
      return 4;
    case T:
    case D:
    case S:
    case Z:
    case TH:
    case DH:
      return 5;
    case CH:
    case JH:
    case SH:
    case ZH:
      return 6;
    case AA:
    case AO:
    case IY:
    case IH:
    case EH:
    case EY:
    case AE:
    case AY:
    case OY:
      return 7;
    case K:
    case G:
    case N:
    case L:
    case NG:
    case HH:
    case Y:
      return 8;
    case AH:
    case AX:
    case ER:
      return 9;
    case Rest:
      return 10;
  }
  return 10;
}

std::vector<Claimant> claimants_of(std::span<const TimedSegment> segments) {
  std::vector<Claimant> claimants;
  claimants.reserve(segments.size());
  for (const auto& timed : segments) {
    const auto& segment = timed.segment;
    const Phone phone = segment.share() < 0.5 ? segment.from : segment.to;
    claimants.push_back({.start = timed.start,
                         .end = timed.end(),
                         .rank = deformability(phone),
                         .is_nucleus = is_vowel(phone) || phone == Phone::Rest,
                         .is_rest = phone == Phone::Rest});
  }
  return claimants;
}

}  // namespace bimodal::synth
