#include "runner/cli/lip_summary.hpp"

#include <algorithm>

namespace bimodal::runner {

namespace {

using synth::Closure;
using synth::Rounding;

double start_ms(const TimedPhone& phone) {
  return Milliseconds{phone.start}.count();
}

double centre_ms(const TimedPhone& phone) {
  return (Milliseconds{phone.start} + Milliseconds{phone.duration} / 2).count();
}

/// Gathers the times of one kind of moment.
class Moments {
 public:
  void add(std::optional<double> measured, std::optional<double> predicted, double origin) {
    if (measured) measured_.push_back(*measured - origin);
    if (predicted) predicted_.push_back(*predicted - origin);
    if (measured && predicted) difference_.push_back(*predicted - *measured);
  }

  [[nodiscard]] MomentSummary summary(std::string_view phones,
                                      std::string_view measure,
                                      std::string_view moment) const {
    return {.phones = phones,
            .measure = measure,
            .moment = moment,
            .measured = synth::middle_of(measured_),
            .predicted = synth::middle_of(predicted_),
            .difference = synth::middle_of(difference_)};
  }

 private:
  std::vector<double> measured_;
  std::vector<double> predicted_;
  std::vector<double> difference_;
};

/// A time of an event that may be absent.
template <typename Event, typename Time>
std::optional<double> time_of(const std::optional<Event>& event, Time Event::*time) {
  if (!event) return std::nullopt;
  return (*event).*time;
}

}  // namespace

std::vector<std::string> measures_of(std::span<const ClipComparison> clips) {
  std::vector<std::string> names;
  for (const auto& clip : clips) {
    for (const auto& one : clip.measures) {
      if (std::ranges::find(names, one.measure) == names.end()) names.push_back(one.measure);
    }
  }
  return names;
}

const MeasureComparison* comparison_of(const ClipComparison& clip, const std::string& measure) {
  const auto found = std::ranges::find(clip.measures, measure, &MeasureComparison::measure);
  return found == clip.measures.end() ? nullptr : &*found;
}

synth::Agreement over_clips(std::span<const ClipComparison> clips, const std::string& measure) {
  std::vector<synth::Agreement> all;
  for (const auto& clip : clips) {
    if (const auto* const one = comparison_of(clip, measure)) all.push_back(one->agreement);
  }
  return synth::over_clips(all);
}

std::vector<MomentSummary> moments_of(std::span<const ClipComparison> clips) {
  Moments lowest;
  Moments half_way;
  Moments narrowest;
  for (const auto& clip : clips) {
    for (const auto& [phone, measured, predicted] : clip.closures) {
      lowest.add(time_of(measured, &Closure::time_ms),
                 time_of(predicted, &Closure::time_ms),
                 centre_ms(phone));
    }
    for (const auto& [phone, measured, predicted] : clip.roundings) {
      half_way.add(time_of(measured, &Rounding::half_way_ms),
                   time_of(predicted, &Rounding::half_way_ms),
                   start_ms(phone));
      narrowest.add(time_of(measured, &Rounding::narrowest_ms),
                    time_of(predicted, &Rounding::narrowest_ms),
                    centre_ms(phone));
    }
  }
  return {lowest.summary("P B M", "inner_h", "lowest, from the centre"),
          half_way.summary("W UW", "outer_w", "half of the fall, from the onset"),
          narrowest.summary("W UW", "outer_w", "narrowest, from the centre")};
}

Closed closed_of(std::span<const ClipComparison> clips) {
  Closed found;
  const auto shut = [](const std::optional<Closure>& closure) {
    return closure && closure->lowest_mm < synth::kShutMm ? 1U : 0U;
  };
  for (const auto& clip : clips) {
    for (const auto& [phone, measured, predicted] : clip.closures) {
      ++found.tokens;
      found.measured += shut(measured);
      found.predicted += shut(predicted);
    }
  }
  return found;
}

std::map<Phone, PhoneMean> phone_means(std::span<const ClipComparison> clips,
                                       const std::string& measure) {
  std::map<Phone, PhoneMean> means;
  for (const auto& clip : clips) {
    const auto* const one = comparison_of(clip, measure);
    if (one == nullptr) continue;
    for (const auto& value : one->phones) {
      auto& mean = means[value.phone];
      ++mean.count;
      mean.measured += value.measured;
      mean.predicted += value.predicted;
    }
  }
  for (auto& [phone, mean] : means) {
    mean.measured /= static_cast<double>(mean.count);
    mean.predicted /= static_cast<double>(mean.count);
  }
  return means;
}

}  // namespace bimodal::runner
