#include "analysis/report/benefit_table.hpp"

#include <cmath>

#include <fmt/format.h>

namespace bimodal::analysis {

namespace {

using Json = nlohmann::ordered_json;

/// Two decimals without leading zero; these may be negative.
std::string two_decimals(const std::optional<double>& value) {
  if (!value) return "-";
  auto text = fmt::format("{:.2f}", std::abs(*value));
  if (text.starts_with("0.")) text.erase(0, 1);
  return (*value < 0.0 && text != ".00" ? "-" : "") + text;
}

std::string interval_text(const std::optional<Interval>& interval) {
  if (!interval) return {};
  return fmt::format(" [{}, {}]", two_decimals(interval->low), two_decimals(interval->high));
}

Json json_of(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json json_of(const std::optional<Interval>& interval) {
  return interval ? Json{interval->low, interval->high} : Json();
}

}  // namespace

std::string benefit_text(std::span<const BenefitRow> rows, std::span<const ShareRow> shares) {
  std::string text;
  for (const auto& row : rows) {
    text += fmt::format(
        "  {} against {}: A {}, AV {}{}; AV - A {}{}; (AV - A) / (1 - A) {}{}; log odds {}{}\n"
        "    n {} and {}; {}\n",
        row.bimodal,
        row.auditory,
        two_decimals(row.a),
        two_decimals(row.av),
        row.v ? fmt::format(", V {} ({})", two_decimals(row.v), row.visual) : "",
        two_decimals(row.benefit.gain),
        interval_text(row.gain_interval),
        two_decimals(row.benefit.relative),
        interval_text(row.relative_interval),
        two_decimals(row.benefit.log_odds),
        row.benefit.excess
            ? fmt::format("; above two independent chances {}", two_decimals(row.benefit.excess))
            : "",
        row.n,
        row.n_auditory,
        row.method);
  }
  for (const auto& share : shares) {
    text += fmt::format("  {} gives {}{} of the benefit of {} (over {}; {})\n",
                        share.synthetic,
                        two_decimals(share.share),
                        interval_text(share.interval),
                        share.natural,
                        share.auditory,
                        share.method);
  }
  return text.empty() ? text : "\nWhat the face adds to the voice, in words correct\n\n" + text;
}

Json benefit_json(std::span<const BenefitRow> rows) {
  Json json = Json::array();
  for (const auto& row : rows) {
    json.push_back({{"bimodal", row.bimodal},
                    {"auditory", row.auditory},
                    {"visual", row.visual.empty() ? Json() : Json(row.visual)},
                    {"participants", row.participants},
                    {"words", row.words},
                    {"n", row.n},
                    {"n_auditory", row.n_auditory},
                    {"n_visual", row.n_visual},
                    {"a", row.a},
                    {"av", row.av},
                    {"v", json_of(row.v)},
                    {"gain", row.benefit.gain},
                    {"gain_interval", json_of(row.gain_interval)},
                    {"relative_gain", json_of(row.benefit.relative)},
                    {"relative_gain_interval", json_of(row.relative_interval)},
                    {"auditory_relative_gain", json_of(row.benefit.auditory_relative)},
                    {"log_odds_gain", json_of(row.benefit.log_odds)},
                    {"excess_over_probability_summation", json_of(row.benefit.excess)},
                    {"method", row.method}});
  }
  return json;
}

Json share_json(std::span<const ShareRow> shares) {
  Json json = Json::array();
  for (const auto& share : shares) {
    json.push_back({{"natural", share.natural},
                    {"synthetic", share.synthetic},
                    {"auditory", share.auditory},
                    {"participants", share.participants},
                    {"words", share.words},
                    {"share_of_natural_benefit", json_of(share.share)},
                    {"interval", json_of(share.interval)},
                    {"method", share.method}});
  }
  return json;
}

}  // namespace bimodal::analysis
