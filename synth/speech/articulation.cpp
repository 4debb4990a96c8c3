#include "synth/speech/articulation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace bimodal::synth {

namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

void append(std::vector<TimedPhone>& segments, const TimedPhone& segment) {
  const bool continues_rest =
      segment.phone == Phone::Rest && !segments.empty() && segments.back().phone == Phone::Rest;
  if (continues_rest) {
    segments.back().duration += segment.duration;
  } else {
    segments.push_back(segment);
  }
}

Duration scaled(Duration duration, double ratio) {
  return Duration{std::llround(static_cast<double>(duration.count()) * ratio)};
}

}  // namespace

std::vector<TimedPhone> segments_of(const Utterance& utterance) {
  std::vector<TimedPhone> segments;
  for (const auto& timed : utterance.phones) {
    const auto parts = face_segments(timed.phone);
    if (parts.size() == 1) {
      append(segments, timed);
      continue;
    }
    assert(parts.size() == 2);
    const Duration first = scaled(timed.duration, kDiphthongSplit);
    append(segments, {.phone = parts[0], .start = timed.start, .duration = first});
    append(segments,
           {.phone = parts[1], .start = timed.start + first, .duration = timed.duration - first});
  }
  if (segments.empty()) segments.push_back({.phone = Phone::Rest});
  return segments;
}

std::vector<Claim> claims_on(Control control,
                             const std::vector<TimedPhone>& segments,
                             const SegmentTable& table) {
  std::vector<Claim> claims;
  claims.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto& segment = segments[i];
    const auto& asked = table.at(segment.phone, control);
    Dominance dominance = asked.dominance;
    Duration centre = segment.start + segment.duration / 2;
    if (segment.phone == Phone::Rest) {
      if (i == 0) {
        dominance.theta_before = 0;
        centre = segment.end() - kRestDistance;
      }
      if (i + 1 == segments.size()) {
        dominance.theta_after = 0;
        centre = segment.start + kRestDistance;
      }
    }
    claims.push_back(
        {.peak = centre + asked.offset, .target = asked.target, .dominance = dominance});
  }
  return claims;
}

Articulation::Articulation(const Utterance& utterance, const SegmentTable& table)
    : end_{utterance.end()} {
  const auto segments = segments_of(utterance);
  for (const auto& description : controls().first<kSpeechControlCount>()) {
    std::vector<Peak> peaks;
    ControlTargets wanted{.control = description.control, .targets = {}};
    for (const auto& claim : claims_on(description.control, segments, table)) {
      const auto& dominance = claim.dominance;
      peaks.push_back({.time_ms = Milliseconds{claim.peak}.count(),
                       .log_alpha = std::log(dominance.alpha),
                       .theta_before = dominance.theta_before,
                       .theta_after = dominance.theta_after,
                       .exponent = dominance.exponent});
      wanted.targets.push_back(claim.target);
    }
    const auto same = std::ranges::find(channels_, peaks, &Channel::peaks);
    if (same == channels_.end()) {
      channels_.push_back({.peaks = std::move(peaks), .controls = {std::move(wanted)}});
    } else {
      same->controls.push_back(std::move(wanted));
    }
  }
}

void Articulation::blend(const Channel& channel,
                         double time_ms,
                         std::vector<double>& weights,
                         Pose& pose) {
  const auto& peaks = channel.peaks;
  weights.resize(peaks.size());
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    const double tau = peaks[i].time_ms - time_ms;
    const double theta = tau >= 0 ? peaks[i].theta_before : peaks[i].theta_after;
    const double distance = std::abs(tau);
    const double powered =
        peaks[i].exponent == 1.0 ? distance : std::pow(distance, peaks[i].exponent);
    weights[i] = peaks[i].log_alpha - theta * powered;
    largest = std::max(largest, weights[i]);
  }

  // Divided by the largest, so that they stay meaningful where every dominance underflows.
  double total = 0;
  for (double& weight : weights) {
    weight = std::exp(weight - largest);
    total += weight;
  }
  for (const auto& [control, targets] : channel.controls) {
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * targets[i];
    value(pose, control) = sum / total;
  }
}

Pose Articulation::at(Duration time) const {
  std::vector<double> weights;
  return at(time, weights);
}

Pose Articulation::at(Duration time, std::vector<double>& weights) const {
  Pose pose = neutral_pose();
  for (const auto& channel : channels_) {
    blend(channel, Milliseconds{time}.count(), weights, pose);
  }
  return pose;
}

std::vector<Pose> Articulation::sample(Hertz rate) const {
  assert(rate.count() > 0);
  std::vector<Pose> poses;
  std::vector<double> weights;
  for (std::int64_t frame = 0;; ++frame) {
    const double nanoseconds = static_cast<double>(frame) * 1e9 / rate.count();
    const Duration time{std::llround(nanoseconds)};
    if (time >= end_) return poses;
    poses.push_back(at(time, weights));
  }
}

}  // namespace bimodal::synth
