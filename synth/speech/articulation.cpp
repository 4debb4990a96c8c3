#include "synth/speech/articulation.hpp"

#include <cassert>

#include "synth/speech/claims.hpp"

namespace bimodal::synth {

namespace {

std::shared_ptr<const Movement> movement_of(const std::vector<TimedSegment>& segments,
                                            const SegmentTable& table,
                                            Account account) {
  ControlClaims claims;
  claims.reserve(kSpeechControlCount);
  std::vector<std::size_t> contacts;
  for (const auto& description : controls().first<kSpeechControlCount>()) {
    if (makes_contact(description.control)) contacts.push_back(claims.size());
    claims.push_back(claims_on(description.control, segments, table));
  }
  return movement(account, claimants_of(segments), claims, contacts);
}

}  // namespace

Articulation::Articulation(const Utterance& utterance, const SegmentTable& table, Account account)
    : movement_{movement_of(segments_of(utterance), table, account)}, end_{utterance.end()} {}

Articulation::Articulation(std::span<const TimedSegment> utterance,
                           const SegmentTable& table,
                           Account account)
    : movement_{movement_of(face_segments(utterance), table, account)},
      end_{utterance.empty() ? Milliseconds{} : utterance.back().end()} {}

Pose Articulation::at(Milliseconds time) const {
  Pose pose = neutral_pose();
  movement_->at(time, std::span{pose}.first<kSpeechControlCount>());
  return pose;
}

std::vector<Pose> Articulation::sample(Hertz rate) const {
  assert(rate.count() > 0);
  std::vector<Pose> poses;
  poses.reserve(1 + static_cast<std::size_t>(Milliseconds{end_}.count() / 1e3 * rate.count()));
  for (std::int64_t frame = 0;; ++frame) {
    const Milliseconds time{static_cast<double>(frame) * 1e3 / rate.count()};
    if (time >= end_) return poses;
    poses.push_back(at(time));
  }
}

}  // namespace bimodal::synth
