#include "synth/speech/tracks.hpp"

#include <algorithm>
#include <iterator>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/csv.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/nearest.hpp"

namespace bimodal::synth {

namespace {

/// Leaves only the controls that were asked for, in the order of the question.
void choose(Tracks& tracks, const ScoreClaims& claims, const std::vector<std::string>& wanted) {
  if (wanted.empty()) {
    tracks.controls = claims.controls;
    tracks.claims = claims.claims;
    return;
  }
  for (const auto& name : wanted) {
    const auto found = std::ranges::find(claims.controls, name);
    if (found == claims.controls.end()) {
      const std::vector<std::string_view> known(claims.controls.begin(), claims.controls.end());
      const auto near = nearest(name, known);
      throw Error{fmt::format("'{}' is no control of this score; {}there are {}",
                              name,
                              near ? fmt::format("did you mean '{}'? ", *near) : "",
                              fmt::join(known, ", "))};
    }
    if (std::ranges::find(tracks.controls, name) != tracks.controls.end()) {
      throw Error{fmt::format("'{}' is asked for twice; once is enough", name)};
    }
    tracks.controls.push_back(name);
    tracks.claims.push_back(
        claims.claims[static_cast<std::size_t>(found - claims.controls.begin())]);
  }
}

std::size_t samples_before(Milliseconds end, Hertz rate) {
  const double exact = end.count() / 1e3 * rate.count();
  auto count = static_cast<std::size_t>(exact);
  while (static_cast<double>(count) * 1e3 / rate.count() < end.count()) ++count;
  return count;
}

double columns_of(const Tracks& tracks, bool with_dominance) {
  double columns = static_cast<double>(tracks.controls.size());
  if (!with_dominance) return columns;
  for (const auto& claims : tracks.claims) columns += static_cast<double>(claims.size());
  return columns;
}

/// A claim as a score has it.
nlohmann::ordered_json told(const Claim& claim, Milliseconds offset) {
  const auto& dominance = claim.dominance;
  nlohmann::ordered_json told{{"target", claim.target},
                              {"alpha", dominance.alpha},
                              {"theta_before_per_ms", dominance.theta_before},
                              {"theta_after_per_ms", dominance.theta_after},
                              {"exponent", dominance.exponent},
                              {"offset_ms", offset.count()}};
  if (dominance.form == DominanceForm::CriticallyDamped) told["form"] = "critically damped";
  if (dominance.inflection_ms != Dominance::kNoInflection) {
    told["inflection_ms"] = std::max(0.0, dominance.inflection_ms - offset.count());
    told["theta_early_per_ms"] = dominance.theta_early;
  }
  return told;
}

}  // namespace

Tracks sample(const ScoreClaims& claims, const TrackOptions& options) {
  Tracks tracks{.rate = options.rate, .symbols = claims.symbols, .segments = claims.claimants};
  choose(tracks, claims, options.controls);
  const double length = claims.end.count() / 1e3 * options.rate.count();
  if (length * columns_of(tracks, options.with_dominance) > kMostSamples) {
    throw Error{fmt::format(
        "{:.0f} instants of {:.0f} columns are too many; choose fewer controls or a lower rate, or "
        "leave the dominances out",
        length,
        columns_of(tracks, options.with_dominance))};
  }
  const auto count = samples_before(claims.end, options.rate);
  tracks.time_ms.reserve(count);
  tracks.values.assign(tracks.controls.size(), std::vector<double>(count));
  const auto moving =
      movement(options.account, tracks.segments, tracks.claims, contact_rows(tracks.controls));
  std::vector<double> values(tracks.controls.size());
  for (std::size_t i = 0; i < count; ++i) {
    tracks.time_ms.push_back(static_cast<double>(i) * 1e3 / options.rate.count());
    moving->at(Milliseconds{tracks.time_ms.back()}, values);
    for (std::size_t control = 0; control < values.size(); ++control) {
      tracks.values[control][i] = values[control];
    }
  }
  if (!options.with_dominance) return tracks;
  for (const auto& asked : tracks.claims) {
    auto& table = tracks.dominance.emplace_back();
    for (const auto& claim : asked) {
      auto& row = table.emplace_back();
      row.reserve(count);
      for (const double time : tracks.time_ms) {
        row.push_back(claim.dominance.at(Milliseconds{time} - claim.peak));
      }
    }
  }
  return tracks;
}

std::string csv_of(const Tracks& tracks) {
  std::string text = "time_ms";
  const auto out = std::back_inserter(text);
  for (const auto& name : tracks.controls) fmt::format_to(out, ",{}", csv_field(name));
  for (std::size_t control = 0; control < tracks.dominance.size(); ++control) {
    for (const auto& claim : tracks.claims[control]) {
      fmt::format_to(
          out, ",{}", csv_field(fmt::format("{}@{}", tracks.controls[control], claim.segment)));
    }
  }
  text += '\n';
  for (std::size_t i = 0; i < tracks.time_ms.size(); ++i) {
    fmt::format_to(out, "{}", tracks.time_ms[i]);
    for (const auto& values : tracks.values) fmt::format_to(out, ",{}", values[i]);
    for (const auto& table : tracks.dominance) {
      for (const auto& row : table) fmt::format_to(out, ",{}", row[i]);
    }
    text += '\n';
  }
  return text;
}

std::string json_of(const Tracks& tracks) {
  nlohmann::ordered_json root;
  root["rate_hz"] = tracks.rate.count();
  auto& segments = root["segments"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < tracks.segments.size(); ++i) {
    const auto& claimant = tracks.segments[i];
    nlohmann::ordered_json segment{{"symbol", tracks.symbols[i]},
                                   {"start_ms", claimant.start.count()},
                                   {"duration_ms", (claimant.end - claimant.start).count()}};
    auto& controls = segment["controls"] = nlohmann::ordered_json::object();
    for (std::size_t control = 0; control < tracks.controls.size(); ++control) {
      const auto& claims = tracks.claims[control];
      const auto claim = std::ranges::find(claims, i, &Claim::segment);
      if (claim == claims.end()) continue;
      const auto centre = (claimant.start + claimant.end) / 2;
      controls[tracks.controls[control]] = told(*claim, claim->peak - centre);
    }
    segments.push_back(std::move(segment));
  }
  root["time_ms"] = tracks.time_ms;
  auto& controls = root["controls"] = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < tracks.controls.size(); ++i) {
    controls[tracks.controls[i]] = tracks.values[i];
  }
  if (!tracks.dominance.empty()) {
    auto& dominance = root["dominance"] = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < tracks.controls.size(); ++i) {
      dominance[tracks.controls[i]] = tracks.dominance[i];
    }
  }
  return root.dump(1) + "\n";
}

}  // namespace bimodal::synth
