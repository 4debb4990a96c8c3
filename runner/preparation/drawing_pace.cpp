#include "runner/preparation/drawing_pace.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "protocols/model/talker.hpp"
#include "runner/devices/monotonic_clock.hpp"
#include "runner/preparation/face_talker.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/timeline/inventory_file.hpp"

namespace bimodal::runner {

namespace {

using namespace std::chrono_literals;

/// Pixels a second, then what is drawn in them: as far as looks are to be compared.
auto cost(const ShownLook& look) {
  constexpr double kUsualRate = 60.0;
  const double rate = look.frame_rate ? std::min(look.frame_rate->count(), kUsualRate) : kUsualRate;
  const bool is_seen_through = look.face.transparency > 0.0;
  return std::tuple{static_cast<double>(look.lines * look.lines) * rate,
                    is_seen_through,
                    shown_parts(look.face).count()};
}

}  // namespace

std::optional<ShownLook> costliest_face(const protocols::Protocol& protocol,
                                        const std::vector<protocols::PlannedTrial>& plan,
                                        const std::map<std::string, Corpus>& corpora) {
  std::optional<ShownLook> costliest;
  for (std::size_t i = 0; i < protocol.conditions.size(); ++i) {
    const auto& condition = protocol.conditions[i];
    if (!condition.visual_talker || protocols::is_corpus(*condition.visual_talker)) continue;
    if (std::ranges::find(plan, i, &protocols::PlannedTrial::condition) == plan.end()) continue;
    const auto look = decide_look(condition, protocol.window, corpora);
    if (!costliest || cost(look) > cost(*costliest)) costliest = look;
  }
  return costliest;
}

Duration measure_full_picture(const ShownLook& look) {
  constexpr std::size_t kPictures = 5;
  constexpr Duration kStep = 60ms;
  constexpr std::array<TimedSegment, 2> kSaid{
      {{.segment = Phone::M, .start = 0ms, .duration = 150ms},
       {.segment = Phone::AA, .start = 150ms, .duration = 250ms}}};
  const synth::SegmentTable table{inventory_file("english")};
  const synth::Head head{asset("synth/assets/head")};
  FaceTalker talker{head, look, synth::Quality::Full};
  auto every_picture = look;
  every_picture.frame_rate.reset();
  const auto face =
      with_look(talker.say(kSaid, table, Account::Dominance, bearing_of(look.face)), every_picture);
  static_cast<void>(face->paint(0ms));  // the first one also compiles shaders
  const MonotonicClock clock;
  std::array<Duration, kPictures> times{};
  for (std::size_t i = 0; i < kPictures; ++i) {
    const auto begin = clock.now();
    static_cast<void>(face->paint(static_cast<int>(i + 1) * kStep));
    times.at(i) = clock.now() - begin;
  }
  std::ranges::nth_element(times, times.begin() + kPictures / 2);
  return times.at(kPictures / 2);
}

}  // namespace bimodal::runner
